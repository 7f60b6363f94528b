#version 3.7;
#declare Ball = sphere { 0, 1 }
#declare A = max_extent(Ball);
#declare B = max_extent(<1, 2, 3>);
