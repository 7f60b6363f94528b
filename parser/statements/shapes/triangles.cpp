// triangle, smooth_triangle, polygon.
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {

ShapeNode parse_triangle(Parser& parser) {
  TriangleNode node;
  for (Vec3& vertex : node.vertex) {
    vertex = parser.parse_vector();
    parser.accept_comma();
  }
  return node;
}

ShapeNode parse_smooth_triangle(Parser& parser) {
  SmoothTriangleNode node;
  for (int i = 0; i < 3; ++i) {
    node.vertex[i] = parser.parse_vector();
    parser.accept_comma();
    node.normal[i] = normalize_or_zero(parser.parse_vector());
    parser.accept_comma();
  }
  return node;
}

ShapeNode parse_polygon(Parser& parser) {
  PolygonNode node;
  const int count = parser.parse_int();
  parser.accept_comma();
  if (count < 3) parser.error("a polygon needs at least three points");
  parser.check_limit(static_cast<uint64_t>(count), parser.options().limits.max_array_elements,
                     "points of a polygon");
  for (int i = 0; i < count; ++i) {
    node.points.push_back(parser.parse_vector());
    parser.accept_comma();
  }
  return node;
}

}  // namespace durer
