// Values at the ends of what warps and turbulence accept: no octaves, no size, no orientation.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4.0, 2.0, -20> look_at <4.0, 2.0, 0> up 6*y right 8*x }
light_source { <-30, 50, -60>, 1 }
background { rgb <0.2, 0.3, 0.5> }
#default { finish { ambient 1 diffuse 0 } }
#declare Place = <0 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 turbulence 1 octaves 0 } translate Place }
#declare Place = <1 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 turbulence 1 octaves 100 } translate Place }
#declare Place = <2 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 turbulence 1 lambda 0 } translate Place }
#declare Place = <3 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 turbulence 1 lambda -2 } translate Place }
#declare Place = <4 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 turbulence 1 omega 2 } translate Place }
#declare Place = <5 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 turbulence 1 omega -1 } translate Place }
#declare Place = <7 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { repeat 1e-3*x } } translate Place }
#declare Place = <0 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { repeat -x } } translate Place }
#declare Place = <1 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { black_hole 0, 0 } } translate Place }
#declare Place = <2 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { black_hole 0, 0.4 strength 0 } } translate Place }
#declare Place = <3 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { black_hole 0, 0.4 strength 1e10 } } translate Place }
#declare Place = <4 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { black_hole 0, 0.4 falloff 0 } } translate Place }
#declare Place = <5 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { black_hole 0, 0.4 falloff -1 } } translate Place }
#declare Place = <6 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { black_hole 0, -1 } } translate Place }
#declare Place = <7 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { black_hole 0, 0.4 inverse falloff -3 } } translate Place }
#declare Place = <0 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { black_hole 0, 0.4 repeat 0 } } translate Place }
#declare Place = <1 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { black_hole 0.1, 0.3 repeat 1e-3*x } } translate Place }
#declare Place = <2 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { turbulence 0 } } translate Place }
#declare Place = <3 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { turbulence 1 octaves 0 } } translate Place }
#declare Place = <4 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { turbulence 1 lambda 0 } } translate Place }
#declare Place = <5 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { planar 0, 0.2 } } translate Place }
#declare Place = <6 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { spherical orientation 0 } } translate Place }
#declare Place = <7 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { cylindrical orientation 0 } } translate Place }
#declare Place = <0 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { toroidal orientation 0 } } translate Place }
#declare Place = <1 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { cylindrical dist_exp -1 } } translate Place }
#declare Place = <2 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { spherical dist_exp -1 } } translate Place }
#declare Place = <3 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { toroidal major_radius 0 } } translate Place }
#declare Place = <4 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { toroidal major_radius -1 } } translate Place }
#declare Place = <5 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 warp { toroidal dist_exp -3 } } translate Place }
#declare Place = <6 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 scale <1e6, 1, 1> } translate Place }
#declare Place = <7 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.3 scale -1e-2 } translate Place }
