#version 3.7;
#declare Patch = triangle { 0, x, y }
#declare A = inside(Patch, <0, 0, 0>);
