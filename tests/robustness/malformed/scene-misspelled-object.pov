#version 3.7;
camera { location -5 * z }
spere { 0, 1 }
