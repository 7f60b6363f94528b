// Every shape: its keyword and who reads its parameters.
#include "parser/statements/objects.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {

const ShapeEntry* find_shape(Keyword keyword) {
  static constexpr ShapeEntry kShapes[] = {
      {Keyword::sphere, "sphere", parse_sphere},
      {Keyword::box, "box", parse_box},
      {Keyword::plane, "plane", parse_plane},
      {Keyword::cylinder, "cylinder", parse_cylinder},
      {Keyword::cone, "cone", parse_cone},
      {Keyword::triangle, "triangle", parse_triangle},
      {Keyword::smooth_triangle, "smooth_triangle", parse_smooth_triangle},
      {Keyword::torus, "torus", parse_torus},
      {Keyword::disc, "disc", parse_disc},
      {Keyword::mesh, "mesh", parse_mesh},
      {Keyword::mesh2, "mesh2", parse_mesh2},
      {Keyword::superellipsoid, "superellipsoid", parse_superellipsoid},
      {Keyword::ovus, "ovus", parse_ovus},
      {Keyword::quadric, "quadric", parse_quadric},
      {Keyword::polygon, "polygon", parse_polygon},
      {Keyword::cubic, "cubic", parse_cubic},
      {Keyword::quartic, "quartic", parse_quartic},
      {Keyword::poly, "poly", parse_poly},
      {Keyword::polynomial, "polynomial", parse_polynomial},
      {Keyword::lathe, "lathe", parse_lathe},
      {Keyword::sor, "sor", parse_sor},
      {Keyword::prism, "prism", parse_prism},
      {Keyword::sphere_sweep, "sphere_sweep", parse_sphere_sweep},
      {Keyword::blob, "blob", parse_blob},
      {Keyword::text, "text", parse_text},
      {Keyword::height_field, "height_field", parse_height_field},
      {Keyword::bicubic_patch, "bicubic_patch", parse_bicubic_patch},
      {Keyword::isosurface, "isosurface", parse_isosurface},
      {Keyword::parametric, "parametric", parse_parametric},
      {Keyword::julia_fractal, "julia_fractal", parse_julia_fractal},
  };
  for (const ShapeEntry& entry : kShapes) {
    if (entry.keyword == keyword) return &entry;
  }
  return nullptr;
}

}  // namespace durer
