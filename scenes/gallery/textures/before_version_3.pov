// Language 2: pigment, normal and finish items stand in texture{} itself. wood and marble are ramps,
// turbulence is the pigment's, frequency and phase are the normal's, moves reach what stands before them.
#version 2.0
camera { location <0, 2.2, -11> direction <0, 0, 2> look_at <0, 0.2, 0> }
object { light_source { <-6, 9, -10> color red 0.9 green 0.9 blue 0.9 } }
object { light_source { <7, 4, -8> color red 0.3 green 0.3 blue 0.3 } }
#declare Warm = color red 0.9 green 0.6 blue 0.3
#declare Bands = color_map { [0 0.5 color Warm color red 0.4 green 0.1] [0.5 1.001 color red 0.4 green 0.1 color Warm] }
#declare Shiny = texture { color red 0.2 green 0.4 blue 0.7 phong 0.8 waves 0.4 frequency 9 scale 0.6 }
#declare Ball = sphere { <0, 0, 0> 0.95 }
plane { <0, 1, 0>, -2 texture { checker color red 0.7 green 0.7 blue 0.7 color red 0.4 green 0.5 blue 0.4 ambient 0.2 } }
object { Ball texture { wood turbulence 0.2 color_map { Bands } rotate <0, 30, 20> scale 0.4 ambient 0.2 phong 1 phong_size 60 } translate <-3.3, 1.4, 0> }
object { Ball texture { marble color_map { Bands } turbulence 0.6 octaves 3 scale 0.5 } translate <-1.1, 1.4, 0> }
object { Ball texture { Warm bumps 0.7 scale 0.15 specular 0.7 roughness 0.03 } translate <1.1, 1.4, 0> }
object { Ball texture { Shiny ambient 0.3 phase 0.4 } translate <3.3, 1.4, 0> }
object { Ball texture { ripples 0.6 frequency 12 scale 0.4 gradient <0, 1, 0> color_map { Bands } scale 0.5 diffuse 0.8 } translate <-3.3, -0.8, 0> }
object { Ball texture { color Warm reflection 0.3 brilliance 2 metallic } texture { bozo color_map { [0 0.5 color red 1 green 1 blue 1 alpha 1 color red 1 green 1 blue 1 alpha 1] [0.5 1.001 color blue 0.6 color green 0.5] } scale 0.3 } translate <-1.1, -0.8, 0> }
object { Ball texture { tiles { texture { hexagon color red 0.8 color Warm color blue 0.6 } tile2 texture { color green 0.5 dents 0.9 scale 0.2 } } scale 0.7 } translate <1.1, -0.8, 0> }
object { Ball texture { color red 0.9 green 1 blue 0.9 alpha 0.9 ambient 0 diffuse 0.1 refraction 1 ior 1.4 phong 1 } translate <3.3, -0.8, 0> }
object { Ball texture { color Warm normal { dents 0.9 scale 0.5 } waves 0.5 scale 0.3 } scale 0.5 translate <-2.2, 0.3, -2> }
object { Ball texture { Shiny normal { wrinkles 0.5 scale 0.5 } bumps 0.6 } scale 0.5 translate <0, 0.3, -2> }
object { Ball texture { pigment { color Warm scale 0.4 } gradient <0, 1, 0> color_map { Bands } } scale 0.5 translate <2.2, 0.3, -2> }
