// sphere, box, plane, cylinder, cone, disc, torus, superellipsoid, ovus, quadric.
#include <cmath>

#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

Vec3 vector_then_comma(Parser& parser) {
  const Vec3 v = parser.parse_vector();
  parser.accept_comma();
  return v;
}

double float_then_comma(Parser& parser) {
  const double f = parser.parse_float();
  parser.accept_comma();
  return f;
}

}  // namespace

ShapeNode parse_sphere(Parser& parser) {
  SphereNode node;
  node.center = vector_then_comma(parser);
  node.radius = parser.parse_float();
  return node;
}

ShapeNode parse_box(Parser& parser) {
  BoxNode node;
  node.corner1 = vector_then_comma(parser);
  node.corner2 = parser.parse_vector();
  return node;
}

ShapeNode parse_plane(Parser& parser) {
  PlaneNode node;
  node.normal = vector_then_comma(parser);
  if (length(node.normal) < kEpsilon) {
    parser.error("a plane's normal must not be the zero vector");
  }
  node.normal = unit_or_zero(node.normal);
  node.distance = parser.parse_float();
  return node;
}

ShapeNode parse_cylinder(Parser& parser) {
  CylinderNode node;
  node.base = vector_then_comma(parser);
  node.apex = vector_then_comma(parser);
  node.radius = parser.parse_float();
  node.open = parser.accept(Keyword::open);
  if (length(node.apex - node.base) < kEpsilon) {
    parser.error("a cylinder's two ends are the same point");
  }
  return node;
}

ShapeNode parse_cone(Parser& parser) {
  ConeNode node;
  node.base = vector_then_comma(parser);
  node.base_radius = float_then_comma(parser);
  node.apex = vector_then_comma(parser);
  node.apex_radius = parser.parse_float();
  node.open = parser.accept(Keyword::open);
  if (length(node.apex - node.base) < kEpsilon) {
    parser.error("a cone's two ends are the same point");
  }
  return node;
}

ShapeNode parse_disc(Parser& parser) {
  DiscNode node;
  node.center = vector_then_comma(parser);
  node.normal = vector_then_comma(parser);
  // Accepted, but nothing will be seen.
  if (length(node.normal) == 0) parser.warning("a disc's normal is the zero vector");
  node.normal = unit_or_zero(node.normal);
  node.radius = float_then_comma(parser);
  node.hole_radius = parser.parse_optional_float(0);
  return node;
}

ShapeNode parse_torus(Parser& parser) {
  TorusNode node;
  node.major_radius = float_then_comma(parser);
  node.minor_radius = parser.parse_float();
  return node;
}

ShapeNode parse_superellipsoid(Parser& parser) {
  SuperellipsoidNode node;
  node.exponents = parser.parse_uv();
  return node;
}

ShapeNode parse_ovus(Parser& parser) {
  OvusNode node;
  node.bottom_radius = float_then_comma(parser);
  node.top_radius = parser.parse_float();
  if (node.bottom_radius < 0 || node.top_radius < 0) {
    parser.error("the radii of an ovus must not be negative");
  }
  if (node.top_radius >= 2 * node.bottom_radius) {
    parser.possible_error("the top radius of this ovus is at least twice the bottom one: it is a sphere");
    return SphereNode{{0, node.bottom_radius, 0}, node.top_radius};
  }
  return node;
}

ShapeNode parse_quadric(Parser& parser) {
  QuadricNode node;
  node.square = vector_then_comma(parser);
  node.mixed = vector_then_comma(parser);
  node.linear = vector_then_comma(parser);
  node.constant = parser.parse_float();
  return node;
}

}  // namespace durer
