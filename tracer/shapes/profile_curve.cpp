#include "tracer/shapes/profile_curve.h"

#include <algorithm>
#include <cmath>

#include "tracer/math/polynomial.h"

namespace durer {
namespace {

void extend(CurveSegment& s, const Vec2& p) {
  s.min = glm::min(s.min, p);
  s.max = glm::max(s.max, p);
}

// Interior extrema of one coordinate.
void extend_by_extrema(CurveSegment& s, int axis) {
  const double a = 3 * s.cubic[axis], b = 2 * s.square[axis], c = s.linear[axis];
  double w[2];
  int count = 0;
  if (std::abs(a) > 1e-10) {
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return;
    const double root = std::sqrt(discriminant);
    w[count++] = (-b + root) / (2 * a);
    w[count++] = (-b - root) / (2 * a);
  } else if (std::abs(b) > 1e-10) {
    w[count++] = -c / b;
  }
  for (int i = 0; i < count; ++i) {
    if (w[i] < 0 || w[i] > 1) continue;
    const double value = s.point(w[i])[axis];
    s.min[axis] = std::min(s.min[axis], value);
    s.max[axis] = std::max(s.max[axis], value);
  }
}

}  // namespace

std::vector<CurveRun> runs_of(const std::vector<CurveSegment>& segments) {
  constexpr size_t kMost = 8;
  std::vector<CurveRun> runs;
  for (size_t first = 0; first < segments.size(); first += kMost) {
    CurveRun run{first, std::min(first + kMost, segments.size()), segments[first].min,
                 segments[first].max};
    for (size_t i = first; i < run.end; ++i) {
      run.min = glm::min(run.min, segments[i].min);
      run.max = glm::max(run.max, segments[i].max);
    }
    runs.push_back(run);
  }
  return runs;
}

void enclose(const std::vector<CurveSegment>& segments, Vec2& min, Vec2& max) {
  min = segments[0].min;
  max = segments[0].max;
  for (const CurveSegment& s : segments) {
    min = glm::min(min, s.min);
    max = glm::max(max, s.max);
  }
}

CurveSegment curve_segment(SplineKind kind, const Vec2* p, bool backwards_bezier) {
  CurveSegment s;
  switch (kind) {
    case SplineKind::linear:
      s.linear = p[1] - p[0];
      s.constant = p[0];
      break;
    case SplineKind::quadratic:
      s.square = 0.5 * p[0] - p[1] + 0.5 * p[2];
      s.linear = -0.5 * p[0] + 0.5 * p[2];
      s.constant = p[1];
      break;
    case SplineKind::cubic:
      s.cubic = -0.5 * p[0] + 1.5 * p[1] - 1.5 * p[2] + 0.5 * p[3];
      s.square = p[0] - 2.5 * p[1] + 2.0 * p[2] - 0.5 * p[3];
      s.linear = -0.5 * p[0] + 0.5 * p[2];
      s.constant = p[1];
      break;
    default:
      if (backwards_bezier) {
        s.cubic = p[0] - 3.0 * p[1] + 3.0 * p[2] - p[3];
        s.square = 3.0 * p[1] - 6.0 * p[2] + 3.0 * p[3];
        s.linear = 3.0 * p[2] - 3.0 * p[3];
        s.constant = p[3];
      } else {
        s.cubic = p[3] - 3.0 * p[2] + 3.0 * p[1] - p[0];
        s.square = 3.0 * p[2] - 6.0 * p[1] + 3.0 * p[0];
        s.linear = 3.0 * p[1] - 3.0 * p[0];
        s.constant = p[0];
      }
      s.min = s.max = p[0];
      for (int i = 1; i < 4; ++i) extend(s, p[i]);
      return s;
  }
  const int from = kind == SplineKind::linear ? 0 : 1;
  s.min = s.max = p[from];
  extend(s, p[from + 1]);
  extend_by_extrema(s, 0);
  extend_by_extrema(s, 1);
  return s;
}

int solve_coordinate(const CurveSegment& s, int degree, int axis, double value, bool sturm,
                     double* roots) {
  const double all[4] = {s.cubic[axis], s.square[axis], s.linear[axis], s.constant[axis] - value};
  double found[3];
  const int count = solve_polynomial(degree, all + 3 - degree, sturm, 0, found);
  int kept = 0;
  for (int i = 0; i < count; ++i)
    if (found[i] >= 0 && found[i] <= 1) roots[kept++] = found[i];
  return kept;
}

}  // namespace durer
