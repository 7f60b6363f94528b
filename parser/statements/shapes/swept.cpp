// lathe, sor, prism, sphere_sweep: shapes swept out by curves (spec/geometry.md 12.8-12.12).
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {
namespace {

bool accept_spline_kind(Parser& parser, SplineKind& kind) {
  if (parser.accept(Keyword::linear_spline)) {
    kind = SplineKind::linear;
  } else if (parser.accept(Keyword::quadratic_spline)) {
    kind = SplineKind::quadratic;
  } else if (parser.accept(Keyword::cubic_spline)) {
    kind = SplineKind::cubic;
  } else if (parser.accept(Keyword::bezier_spline)) {
    kind = SplineKind::bezier;
  } else {
    return false;
  }
  return true;
}

int parse_count(Parser& parser, int least, const char* what) {
  const int count = parser.parse_int();
  parser.accept_comma();
  if (count < least) {
    parser.error(std::string(what) + " needs at least " + std::to_string(least) + " points");
  }
  parser.check_limit(static_cast<uint64_t>(count), parser.options().limits.max_array_elements,
                     "points of a curve");
  return count;
}

std::vector<Vec2> parse_points(Parser& parser, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(parser.parse_uv());
    parser.accept_comma();
  }
  return points;
}

int least_points(SplineKind kind) {
  switch (kind) {
    case SplineKind::linear:
      return 2;
    case SplineKind::quadratic:
      return 3;
    default:
      return 4;
  }
}

}  // namespace

ShapeNode parse_lathe(Parser& parser) {
  LatheNode node;
  while (accept_spline_kind(parser, node.spline)) {
  }
  const int count = parse_count(parser, least_points(node.spline), "this lathe");
  if (node.spline == SplineKind::bezier && count % 4 != 0) {
    parser.error("a bezier_spline takes four points for each segment");
  }
  node.points = parse_points(parser, count);
  return node;
}

ShapeNode parse_sor(Parser& parser) {
  SorNode node;
  const int count = parse_count(parser, 4, "a sor");
  node.points = parse_points(parser, count);
  node.open = parser.accept(Keyword::open);
  for (int i = 0; i < count; ++i) {
    const bool inner = i > 0 && i < count - 1;
    if (inner && node.points[i].x < 0) parser.error("the radii of a sor must not be negative");
    if (i > 1 && inner && node.points[i].y <= node.points[i - 1].y) {
      parser.error("the heights of a sor must increase from point to point");
    }
  }
  return node;
}

ShapeNode parse_prism(Parser& parser) {
  PrismNode node;
  for (;;) {
    if (accept_spline_kind(parser, node.spline)) continue;
    if (parser.accept(Keyword::linear_sweep)) {
      node.conic_sweep = false;
    } else if (parser.accept(Keyword::conic_sweep)) {
      node.conic_sweep = true;
    } else {
      break;
    }
  }
  node.height1 = parser.parse_float();
  parser.accept_comma();
  node.height2 = parser.parse_float();
  parser.accept_comma();
  const int least = node.spline == SplineKind::linear      ? 3
                    : node.spline == SplineKind::quadratic ? 4
                    : node.spline == SplineKind::cubic     ? 5
                                                           : 4;
  const int count = parse_count(parser, least, "this prism");
  if (node.spline == SplineKind::bezier && count % 4 != 0) {
    parser.error("a bezier_spline takes four points for each segment");
  }
  node.points = parse_points(parser, count);
  node.open = parser.accept(Keyword::open);
  return node;
}

ShapeNode parse_sphere_sweep(Parser& parser) {
  SphereSweepNode node;
  if (parser.accept(Keyword::linear_spline)) {
    node.spline = SplineKind::linear;
  } else if (parser.accept(Keyword::cubic_spline)) {
    node.spline = SplineKind::cubic;
  } else if (parser.accept(Keyword::b_spline)) {
    node.spline = SplineKind::b_spline;
  } else {
    parser.error_expected("linear_spline, cubic_spline or b_spline");
  }
  parser.accept_comma();
  const int count =
      parse_count(parser, node.spline == SplineKind::linear ? 2 : 4, "this sphere_sweep");
  for (int i = 0; i < count; ++i) {
    node.centers.push_back(parser.parse_vector());
    parser.accept_comma();
    node.radii.push_back(parser.parse_float());
    parser.accept_comma();
  }
  node.tolerance = node.spline == SplineKind::linear ? 0 : 1e-6;
  if (parser.accept(Keyword::tolerance)) node.tolerance = parser.parse_float();
  return node;
}

}  // namespace durer
