#version 3.7;
light_source { <10, 10, -10>
camera { location 0 }
