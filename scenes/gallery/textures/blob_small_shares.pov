// Components of a blob whose share is below adc_bailout are left out one by one, also of one texture.
#version 3.7;
global_settings { assumed_gamma 1 adc_bailout 0.06 }
camera { location <0, 0.5, -5> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
#declare Spots = seed(4);
blob {
  threshold 0.4
  sphere { 0, 1.5, 1 pigment { rgb <1, 0.3, 0.2> } }
  #declare I = 0;
  #while (I < 40)
    #declare A = 360 * rand(Spots);
    #declare B = 180 * rand(Spots) - 90;
    sphere {
      0, 0.45 + 0.3 * rand(Spots), 0.2
      translate 0.9 * x rotate <0, A, B>
      #if (mod(I, 4) = 0) pigment { checker rgb 1, rgb <0.2, 0.4, 0.9> scale 0.2 } #end
    }
    #declare I = I + 1;
  #end
  pigment { rgb <0.9, 0.8, 0.4> }
  finish { phong 0.4 }
}
