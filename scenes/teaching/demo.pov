// The draughtsman's table: the picture that ./demo renders.
//
// Everything that Whitted's recursion needs is here, made of the basic shapes only: a checkered
// table, a mirror ball, a ball of glass, and constructive solid geometry. Try
//   durer demo.pov --integrator raycast     to see what is left without recursion.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 }

camera {
  location <0.6, 4.6, -10.4>
  look_at <0.1, 0.85, 1.0>
  angle 37
  right x * image_width / image_height
}

light_source { <-9, 13, -6> rgb <1.15, 1.05, 0.90> }
light_source { <12, 7, -6> rgb <0.20, 0.25, 0.34> shadowless }

background { rgb <0.12, 0.19, 0.30> }

// The table: a round slab of two stones, polished, in a frame of brass.
cylinder {
  -0.4 * y, 0, 7.4
  pigment { checker rgb <0.74, 0.70, 0.62>, rgb <0.05, 0.075, 0.12> }
  finish { ambient 0.04 diffuse 0.75 specular 0.25 roughness 0.01 reflection 0.12 }
}

#declare Brass_Finish = finish {
  ambient 0.06 diffuse 0.45 specular 0.8 roughness 0.02 metallic
  reflection { 0.28 metallic }
}
#declare Brass = texture { pigment { rgb <0.88, 0.62, 0.25> } finish { Brass_Finish } }
#declare Lacquer = texture {
  pigment { rgb <0.62, 0.05, 0.035> }
  finish { ambient 0.04 diffuse 0.75 phong 0.7 phong_size 90 reflection 0.07 }
}
#declare Chalk = texture {
  pigment { rgb <0.86, 0.84, 0.79> }
  finish { ambient 0.05 diffuse 0.8 specular 0.1 roughness 0.05 }
}

// A ball of silver ...
sphere {
  <-1.75, 1.35, 1.5>, 1.35
  pigment { rgb <0.92, 0.93, 0.95> }
  finish { ambient 0 diffuse 0.08 specular 0.9 roughness 0.002 reflection 0.86 }
}

// ... one of glass ...
sphere {
  <0.55, 0.78, -1.9>, 0.78
  pigment { rgbf <0.94, 0.99, 0.97, 0.96> }
  finish { ambient 0 diffuse 0.02 specular 0.9 roughness 0.001 reflection { 0.02, 1 fresnel on } conserve_energy }
  interior { ior 1.5 }
}

// ... and a die that shows what difference and intersection do: a cube rounded by a sphere and
// drilled along three axes, with a brass ball held inside.
#declare Drill = cylinder { -2 * y, 2 * y, 0.62 }
union {
  difference {
    intersection {
      box { -1, 1 }
      sphere { 0, 1.36 }
    }
    object { Drill }
    object { Drill rotate 90 * x }
    object { Drill rotate 90 * z }
    texture { Lacquer }
  }
  sphere { 0, 0.66 texture { Brass } }
  rotate 32 * y
  translate <1.75, 1, 1.2>
}

// Cones and cylinders: an obelisk and the draughtsman's plummet.
union {
  cylinder { 0, 0.16 * y, 0.62 }
  cylinder { 0.16 * y, 0.26 * y, 0.5 }
  cone { 0.26 * y, 0.40, 2.35 * y, 0.10 }
  sphere { 2.5 * y, 0.2 }
  texture { Chalk }
  translate <-0.2, 0, 4.2>
}
union {
  cone { 0, 0, 0.55 * y, 0.26 }
  sphere { <0, 0.55, 0>, 0.26 }
  cylinder { 0.5 * y, 0.95 * y, 0.05 }
  texture { Brass }
  rotate 103 * z
  rotate 25 * y
  translate <-1.05, 0.27, -2.2>
}

// A circle of pawns, made by one loop and one macro, stands on the table's brass frame.
#macro Pawn(Place, Height)
  union {
    cylinder { 0, 0.09 * y, 0.27 }
    cone { 0.09 * y, 0.22, Height * y, 0.085 }
    sphere { (Height + 0.12) * y, 0.17 }
    translate Place
  }
#end
union {
  difference {
    cylinder { -0.5 * y, 0.06 * y, 8 }
    cylinder { -0.6 * y, 0.60 * y, 7.4 }
  }
  #for (I, 0, 35)
    Pawn(vrotate(<7.7, 0.06, 0>, 10 * I * y), 0.62 + 0.14 * mod(I, 2))
  #end
  texture { Brass }
}
