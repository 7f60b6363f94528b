// A plain colour keeps what its pigment{} says besides it; a pigment{} that follows gives it a pattern.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 42 }
light_source { <-5, 8, -10> rgb 1 }
#declare Map = color_map { [0 rgb <1, 0.9, 0.5>] [1 rgb <0.5, 0.1, 0.1>] }
#declare Moved = pigment { rgb 1 scale 0.2 rotate 30 * z }
#declare Paint = texture { pigment { Moved } finish { phong 0.6 } }
sphere { <-2.2, 1.1, 0>, 1 pigment { rgb 1 scale 0.2 } pigment { gradient y color_map { Map } } }
sphere { <0, 1.1, 0>, 1 pigment { rgb 1 turbulence 0.5 frequency 3 sine_wave } pigment { gradient y color_map { Map } } }
sphere { <2.2, 1.1, 0>, 1 pigment { bozo color_map { Map } scale 0.2 } pigment { rgb 1 scale 2 } pigment { granite } }
sphere { <-2.2, -1.1, 0>, 1 texture { Paint pigment { checker rgb 1 rgb 0.3 } } }
sphere { <0, -1.1, 0>, 1 pigment { Moved } pigment { wood color_map { Map } } }
sphere { <2.2, -1.1, 0>, 1 pigment { Moved } }
