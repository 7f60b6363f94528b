// The pigments of a sky_sphere take nothing from #default; a camera's normal starts from the default one.
#version 3.7;
global_settings { assumed_gamma 1 }
#default {
  texture {
    pigment {
      bozo phase 0.72 frequency 3.04 turbulence 0.3 scale 0.5
      color_map { [0 rgb <0.75, 0.79, 0.52>] [1 rgb <0.51, 0.26, 0.43>] }
    }
    normal { bumps 0.4 phase 0.2 scale 2 }
  }
}
camera { location <1.29, 3.27, -5.34> look_at <0.05, 4, 1> angle 90 normal { ripples 0.1 } }
light_source { <-7, 5, -6> rgb 1 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.8, 0.8, 1>] [0.6 rgb <0.1, 0.2, 0.6>] } }
  pigment { gradient x color_map { [0 rgbt 1] [0.5 rgbt 1] [1 rgbt <1, 0.5, 0, 0.3>] } }
  rotate <47, 133, -122>
}
sphere { <-1, 4, 0>, 1 pigment { gradient y color_map { [0 rgb 1] [1 rgb 0] } } }
