#version;
sphere { 0, 1 }
