#version 3.7;
#default { finish { ambient 1 }
sphere { 0, 1 }
