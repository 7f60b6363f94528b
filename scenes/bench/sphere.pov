// The smallest scene: what it costs is start-up.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 }
light_source { <3, 5, -4> rgb 1 }
sphere { 0, 1 pigment { rgb <1, 0.6, 0.2> } }
