// Assigning several names at once came with POV-Ray 3.8.
#version 3.7;
#declare (A, B) = (1, 2);
