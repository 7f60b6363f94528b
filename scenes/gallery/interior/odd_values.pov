// Values at the ends of what interiors accept: ior 0 and below, fading of no distance, filter and transmit out of 0 to 1.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3.0, 2.0, -20> look_at <3.0, 2.0, 0> up 4.5*y right 6*x }
light_source { <-30, 50, -60>, 1 }
background { rgb <0.2, 0.3, 0.5> }
plane { -z, -1 pigment { checker rgb 0.3, rgb 0.6 scale 0.3 } }
#declare Place = <0 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 0 } translate Place }
#declare Place = <1 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior -1 } translate Place }
#declare Place = <2 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1e-10 } translate Place }
#declare Place = <3 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 0.2 } translate Place }
#declare Place = <4 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 dispersion 0 } translate Place }
#declare Place = <5 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 dispersion -1 } translate Place }
#declare Place = <0 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 dispersion 5 dispersion_samples 2 } translate Place }
#declare Place = <1 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 fade_distance 0 fade_power 2 } translate Place }
#declare Place = <2 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 fade_distance 1 fade_power 0 } translate Place }
#declare Place = <3 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 fade_distance -1 fade_power 2 } translate Place }
#declare Place = <4 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 fade_distance 1 fade_power -1 } translate Place }
#declare Place = <5 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 fade_distance 1 fade_power 1000 } translate Place }
#declare Place = <0 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 fade_distance 1 fade_power 1001 fade_color rgb 0.3 } translate Place }
#declare Place = <1 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { ior 1.5 fade_distance 1e-20 fade_power 1001 fade_color rgb -1 } translate Place }
#declare Place = <2 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { fade_distance 1 fade_power 1001 fade_color rgb 0 } translate Place }
#declare Place = <3 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { caustics -1 ior 1.5 } translate Place }
#declare Place = <4 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <0.9, 0.8, 0.9, 0.8> } finish { reflection 0.2 } interior { caustics 1e10 ior 1.5 } translate Place }
#declare Place = <5 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <1, 1, 1, 3> } finish { reflection 0.2 } interior { ior 1.5 } translate Place }
#declare Place = <0 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbf <1, 1, 1, -1> } finish { reflection 0.2 } interior { ior 1.5 } translate Place }
#declare Place = <1 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbt <0.5, 1, 1, 4> } finish { reflection 0.2 } interior { ior 1.5 } translate Place }
#declare Place = <2 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgbft <-1, -1, 1, 0.5, 0.5> } finish { reflection 0.2 } interior { ior 1.5 } translate Place }
