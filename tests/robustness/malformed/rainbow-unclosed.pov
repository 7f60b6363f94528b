#version 3.7;
rainbow { angle 42 width 5
sphere { 0, 1 }
