// Arrays of several kinds came with POV-Ray 3.8.
#version 3.7;
#declare D = array mixed [2] { 1, "two" }
