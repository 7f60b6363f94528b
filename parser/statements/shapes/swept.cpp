// lathe, sor, prism, sphere_sweep: shapes swept out by curves (spec/geometry.md 12.8-12.12).
#include <cmath>

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
    if (i + 1 < count) parser.accept_comma();
  }
  return points;
}

constexpr double kEpsilon = 1e-10;

bool same_point(const Vec2& a, const Vec2& b) {
  return std::abs(a.x - b.x) < kEpsilon && std::abs(a.y - b.y) < kEpsilon;
}

constexpr const char* kNotClosed = "the curve of this prism is not closed: it cannot be seen";

// A prism's outline is made of closed curves, each of which begins after the one before has come
// back to its start (spec/geometry.md 12.11).
void close_linear(Parser& parser, std::vector<Vec2>& points) {
  size_t start = 0;
  bool open = false;
  for (size_t i = 0; i < points.size(); ++i) {
    if (!open) {
      start = i;
      open = true;
    } else if (same_point(points[i], points[start])) {
      open = false;
    }
  }
  if (open) {
    parser.warning("the outline of this prism is not closed; its first point is added at the end");
    points.push_back(points[start]);
  }
}

// Quadratic and cubic curves: closed when the second point comes again; `step` points on, the next
// curve has its second point.
void check_curve(Parser& parser, const std::vector<Vec2>& points, bool cubic) {
  size_t reference = 1;
  bool closed = false;
  for (size_t i = 2; i < points.size(); ++i) {
    closed = same_point(points[i], points[reference]);
    if (!closed) continue;
    // A cubic curve needs one more point behind the one that closes it.
    if (cubic && i + 1 == points.size()) closed = false;
    reference = i + (cubic ? 3 : 2);
    if (reference >= points.size()) break;
    i = reference;
    closed = false;
  }
  if (!closed) parser.error("too few points: the curve of this prism is not closed");
}

// Each segment starts where the one before ends, or a closed curve ends there.
void check_bezier(Parser& parser, const std::vector<Vec2>& points) {
  size_t start = 0;
  bool closed = true;
  for (size_t i = 0; i + 3 < points.size(); i += 4) {
    if (i > start && !closed && !same_point(points[i], points[i - 1])) break;
    if (closed) start = i;
    closed = same_point(points[i + 3], points[start]);
  }
  if (!closed) parser.warning(kNotClosed);
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
  for (int i = 1; i < count - 1; ++i) {
    if (node.points[i].x < 0) {
      parser.error("the radii of a lathe must not be negative, but for the first and last");
    }
  }
  return node;
}

ShapeNode parse_sor(Parser& parser) {
  SorNode node;
  const int count = parse_count(parser, 4, "a sor");
  std::vector<Vec2>& points = node.points;
  for (int i = 0; i < count; ++i) {
    points.push_back(parser.parse_uv());
    if (i + 1 < count) parser.accept_comma();
    if (points[i].x < 0) parser.error("the radii of a sor must not be negative");
    // The first and the last point only bend the curve, and may stand anywhere but level with the
    // point after next.
    const bool falls = i >= 2 && i <= count - 2 && points[i].y <= points[i - 1].y;
    const bool level = i >= 2 && std::abs(points[i].y - points[i - 2].y) < kEpsilon;
    if (falls || level) parser.error("the heights of a sor must increase from point to point");
  }
  node.open = parser.accept(Keyword::open);
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
                    : node.spline == SplineKind::quadratic ? 5
                    : node.spline == SplineKind::cubic     ? 6
                                                           : 4;
  const int count = parse_count(parser, least, "this prism");
  if (node.spline == SplineKind::bezier && count % 4 != 0) {
    parser.error("a bezier_spline takes four points for each segment");
  }
  node.points = parse_points(parser, count);
  node.open = parser.accept(Keyword::open);
  if (node.spline == SplineKind::linear) {
    close_linear(parser, node.points);
  } else if (node.spline == SplineKind::bezier) {
    check_bezier(parser, node.points);
  } else {
    check_curve(parser, node.points, node.spline == SplineKind::cubic);
  }
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
    if (i + 1 < count) parser.accept_comma();
  }
  if (parser.accept(Keyword::tolerance)) node.tolerance = parser.parse_float();
  return node;
}

}  // namespace durer
