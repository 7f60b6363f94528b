#version 3.6;
// plotted surface
#declare plot_x0 = -1.0; #declare plot_x1 = 1.0;
camera { orthographic location <2,2,-3> look_at <0,0.2,0> up y*3 right x*4 }
light_source { <5,10,-10> color rgb 1 parallel point_at 0 }
background { color rgb <1,1,1> }
#declare LineTex = texture { pigment { color rgb <0,0,0.6> } finish { ambient 1 diffuse 0 } }
#macro seg(P, Q) cylinder { P, Q, 0.01 texture { LineTex } } #end
#declare f = function(x, z) { 0.4*cos(4*x)*exp(-z*z) }
#declare N = 8;
#declare i = 0;
#while (i < N)
  #declare a = plot_x0 + (plot_x1 - plot_x0)*i/N;
  #declare j = 0;
  #while (j < N)
    #declare b = plot_x0 + (plot_x1 - plot_x0)*j/N;
    #declare s = (plot_x1-plot_x0)/N;
    #declare P1 = <a, f(a,b), b>; #declare P2 = <a+s, f(a+s,b), b>;
    #declare P3 = <a+s, f(a+s,b+s), b+s>; #declare P4 = <a, f(a,b+s), b+s>;
    mesh { triangle { P1, P2, P3 } triangle { P1, P3, P4 }
      texture { pigment { color rgb <0.5+P1.y, 0.5, 0.5-P1.y> } finish { ambient 0.3 } } }
    seg(P1, P2) seg(P1, P4)
    #declare j = j + 1;
  #end
  #declare i = i + 1;
#end
text { ttf "timrom.ttf" concat("max ", str(f(0,0), 0, 2)) 0.05, 0 texture { LineTex } scale 0.3 translate <-1.2, 0.8, 0> }
