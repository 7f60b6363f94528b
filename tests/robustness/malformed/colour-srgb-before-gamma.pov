#version 3.7;
#declare C = srgb <1, 0.5, 0>;
