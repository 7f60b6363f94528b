// Dictionaries came with POV-Ray 3.8.
#version 3.7;
#declare D = dictionary { ["key"]: 3 }
