#version 3.7;
#declare radius = 3;
