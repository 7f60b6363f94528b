#version 3.7;
sky_sphere { rgb 1 }
