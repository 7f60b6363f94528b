#version 3.7;
#declare Where = <1, 2, 3>
sphere { Where, 1 }
