// 81 glass spheres above a checkered plane: refraction, and shadows through glass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 6, -12> look_at <0, 0, -1> }
light_source { <10, 20, -15> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.1, 0.2, 0.5>] } } }
plane { y, -0.5 pigment { checker rgb 0.9, rgb 0.2 } }
#for (Row, -4, 4)
  #for (Column, -4, 4)
    sphere {
      <1.3 * Column, 0, 1.3 * Row>, 0.5
      pigment { rgb <0.9, 0.95, 0.92> filter 0.95 }
      finish { diffuse 0.05 specular 0.8 roughness 0.005 reflection 0.1 }
      interior { ior 1.5 }
    }
  #end
#end
