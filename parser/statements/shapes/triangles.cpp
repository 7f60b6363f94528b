// triangle, smooth_triangle, polygon.
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {
namespace {

constexpr const char* kDegenerate = "this triangle is degenerate and cannot be seen";

Vec3 triangle_normal(const std::array<Vec3, 3>& p) { return cross(p[2] - p[0], p[1] - p[0]); }

// Sub-polygons end where they began: points that nearly equal their start are made equal to it, and
// an open last one is closed (spec/geometry.md 13.3).
void close_polygon(Parser& parser, std::vector<Vec3>& points) {
  constexpr double kEpsilon = 1e-10;
  size_t start = 0;
  bool open = false;
  for (size_t i = 0; i < points.size(); ++i) {
    if (!open) {
      start = i;
      open = true;
      continue;
    }
    const Vec3 gap = glm::abs(points[i] - points[start]);
    if (gap.x < kEpsilon && gap.y < kEpsilon && gap.z < kEpsilon) {
      points[i] = points[start];
      open = false;
    }
  }
  if (open) {
    parser.warning("this polygon is not closed; its first point is added at the end");
    points.push_back(points[start]);
  }
}

}  // namespace

ShapeNode parse_triangle(Parser& parser) {
  TriangleNode node;
  for (int i = 0; i < 3; ++i) {
    node.vertex[i] = parser.parse_vector();
    if (i < 2) parser.accept_comma();
  }
  if (length(triangle_normal(node.vertex)) == 0) parser.warning(kDegenerate);
  return node;
}

ShapeNode parse_smooth_triangle(Parser& parser) {
  SmoothTriangleNode node;
  for (int i = 0; i < 3; ++i) {
    node.vertex[i] = parser.parse_vector();
    parser.accept_comma();
    node.normal[i] = parser.parse_vector();
    if (i < 2) parser.accept_comma();
  }
  // All three normals must lie on one side of the triangle.
  const Vec3 n = triangle_normal(node.vertex);
  const double a = dot(n, node.normal[0]), b = dot(n, node.normal[1]), c = dot(n, node.normal[2]);
  if (!(a > 0 && b > 0 && c > 0) && !(a < 0 && b < 0 && c < 0)) parser.warning(kDegenerate);
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
    if (i + 1 < count) parser.accept_comma();
  }
  close_polygon(parser, node.points);
  return node;
}

}  // namespace durer
