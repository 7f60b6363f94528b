// The parameters of every shape, after its `{` (spec/language.md 24). Each in its family's file.
#pragma once

#include "tracer/scene/shapes.h"

namespace durer {

class Parser;

ShapeNode parse_sphere(Parser& parser);
ShapeNode parse_box(Parser& parser);
ShapeNode parse_plane(Parser& parser);
ShapeNode parse_cylinder(Parser& parser);
ShapeNode parse_cone(Parser& parser);
ShapeNode parse_disc(Parser& parser);
ShapeNode parse_torus(Parser& parser);
ShapeNode parse_superellipsoid(Parser& parser);
ShapeNode parse_ovus(Parser& parser);
ShapeNode parse_quadric(Parser& parser);
ShapeNode parse_triangle(Parser& parser);
ShapeNode parse_smooth_triangle(Parser& parser);
ShapeNode parse_polygon(Parser& parser);
ShapeNode parse_cubic(Parser& parser);
ShapeNode parse_quartic(Parser& parser);
ShapeNode parse_poly(Parser& parser);
ShapeNode parse_polynomial(Parser& parser);
ShapeNode parse_lathe(Parser& parser);
ShapeNode parse_sor(Parser& parser);
ShapeNode parse_prism(Parser& parser);
ShapeNode parse_sphere_sweep(Parser& parser);
ShapeNode parse_blob(Parser& parser);
ShapeNode parse_text(Parser& parser);
ShapeNode parse_height_field(Parser& parser);
ShapeNode parse_bicubic_patch(Parser& parser);
ShapeNode parse_mesh(Parser& parser);
ShapeNode parse_mesh2(Parser& parser);
ShapeNode parse_isosurface(Parser& parser);
ShapeNode parse_parametric(Parser& parser);
ShapeNode parse_julia_fractal(Parser& parser);

}  // namespace durer
