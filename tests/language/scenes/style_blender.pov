#version 3.7;
global_settings {
    assumed_gamma 1.0
    max_trace_level 5
}
#default{ finish{ ambient rgb 0 emission 0 }}

//--Exported with POV-Ray exporter for Blender--
#declare shader_default_A = finish{
    diffuse 0.8
    emission 0
    ambient 0
    specular 0.5
    roughness 0.01
}
camera {
    location  <0, 0, 0>
    look_at  <0, 0, -1>
    right <-1.33333, 0, 0>
    up <0, 1, 0>
    angle  49.134343
    rotate  <-63.559296, -0.000000, -46.691942>
    translate <7.481132, -6.507640, 5.343665>
}
light_source {
    < 0,0,0 >
    color rgb<1, 1, 1>
    fade_distance 29.999983
    fade_power 2
    matrix <-0.290865, -0.771101, 0.566393,  0.955171, -0.199883, 0.218391,  -0.055189, 0.604525, 0.794672,  4.076245, 1.005454, 5.903862>
}
#declare MAT_Material =
    texture {
        pigment { rgbft<0.8, 0.6, 0.2, 0, 0.0>}
        normal { bumps 0.2 scale 0.3 }
        finish {shader_default_A}
    }
#declare DATACube =
mesh2 {
    vertex_vectors {
        8,
        <1.000000, 1.000000, -1.000000>, <1.000000, -1.000000, -1.000000>, <-1.000000, -1.000000, -1.000000>, <-1.000000, 1.000000, -1.000000>, <1.000000, 1.000000, 1.000000>, <1.000000, -1.000000, 1.000000>, <-1.000000, -1.000000, 1.000000>, <-1.000000, 1.000000, 1.000000>
    }
    normal_vectors {
        6,
        <0, 0, -1>, <0, 0, 1>, <1, 0, 0>, <0, -1, 0>, <-1, 0, 0>, <0, 1, 0>
    }
    uv_vectors {
        3, <0,0>,<1,0>,<1,1>
    }
    texture_list {
        1
        texture{MAT_Material}
    }
    face_indices {
        12,
        <0,1,2>,0, <0,2,3>,0, <4,7,6>,0, <4,6,5>,0, <0,4,5>,0, <0,5,1>,0,
        <1,5,6>,0, <1,6,2>,0, <2,6,7>,0, <2,7,3>,0, <4,0,3>,0, <4,3,7>,0
    }
    normal_indices {
        12,
        <0,0,0>, <0,0,0>, <1,1,1>, <1,1,1>, <2,2,2>, <2,2,2>, <3,3,3>, <3,3,3>, <4,4,4>, <4,4,4>, <5,5,5>, <5,5,5>
    }
    uv_indices {
        12,
        <0,1,2>, <0,1,2>, <0,1,2>, <0,1,2>, <0,1,2>, <0,1,2>, <0,1,2>, <0,1,2>, <0,1,2>, <0,1,2>, <0,1,2>, <0,1,2>
    }
}
object { DATACube
    matrix <1.000000, 0.000000, 0.000000, 0.000000, 1.000000, 0.000000, 0.000000, 0.000000, 1.000000, 0.000000, 0.000000, 0.000000>
}
sphere { <2,1,0>, 0.7 texture { MAT_Material } }
background {rgbt<0.05, 0.05, 0.05, 0.75>}
