// Many solids in one intersection: a brilliant cut of 57 planes, and 40 spheres taken from a ball one
// after the other.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 3, -6> look_at <0, -0.1, 0> angle 42 }
light_source { <-6, 8, -10>, 1 }
light_source { <8, 5, -4>, 0.5 }
background { rgb <0.1, 0.15, 0.25> }
plane { y, -1.2 pigment { checker rgb 0.8, rgb <0.3, 0.3, 0.5> } }
intersection {
  plane { y, 0.45 }
  #for (I, 0, 7)
    plane { vrotate(<1, 1.1, 0>, 45 * I * y), 0.85 }
    plane { vrotate(<1, 0.7, 0>, (45 * I + 22.5) * y), 0.95 }
    plane { vrotate(<1, 0.4, 0>, (45 * I + 11.25) * y), 0.98 }
    plane { vrotate(<1, 0.4, 0>, (45 * I - 11.25) * y), 0.98 }
    plane { vrotate(<1, -1, 0>, 45 * I * y), 0.75 }
    plane { vrotate(<1, -0.8, 0>, (45 * I + 11.25) * y), 0.8 }
    plane { vrotate(<1, -0.8, 0>, (45 * I - 11.25) * y), 0.8 }
  #end
  pigment { rgbt <0.95, 0.97, 1, 0.95> }
  finish { specular 0.8 roughness 0.002 reflection { 0, 1 fresnel } conserve_energy }
  interior { ior 2.4 }
  translate <-1.1, 0, 0>
}
#declare Random = seed(11);
#declare Bitten = sphere { 0, 1 pigment { rgb <0.9, 0.8, 0.5> } }
#for (I, 1, 40)
  #declare Bitten = difference {
    object { Bitten }
    sphere { vnormalize(<rand(Random), rand(Random), rand(Random)> - 0.5), 0.25 pigment { rgb <0.7, 0.2, 0.1> } }
  }
#end
object { Bitten translate <1.2, -0.2, 0> finish { phong 0.5 } }
