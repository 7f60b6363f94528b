#version 3.7;
global_settings { charset sys }
#declare A = "plain";
