// The plane curves of lathe and prism (spec/geometry.md 12.8): segments that are polynomials of
// degree 1..3 in w, 0 <= w <= 1.
#pragma once

#include <cstddef>
#include <vector>

#include "tracer/scene/shapes.h"

namespace durer {

struct CurveSegment {
  Vec2 cubic{0}, square{0}, linear{0}, constant{0};
  Vec2 min{0}, max{0};  // encloses the segment

  Vec2 point(double w) const { return ((cubic * w + square) * w + linear) * w + constant; }
  Vec2 tangent(double w) const { return (3.0 * cubic * w + 2.0 * square) * w + linear; }
};

// Some segments that follow each other, for rays that pass all of them.
struct CurveRun {
  size_t first, end;
  Vec2 min, max;  // encloses them
};
std::vector<CurveRun> runs_of(const std::vector<CurveSegment>& segments);

// Encloses all segments, of which there is at least one.
void enclose(const std::vector<CurveSegment>& segments, Vec2& min, Vec2& max);

inline int degree_of(SplineKind kind) {
  return kind == SplineKind::linear ? 1 : kind == SplineKind::quadratic ? 2 : 3;
}

// p: the 2, 3 or 4 control points of a segment. A prism's Bezier segments run from their last point
// to their first.
CurveSegment curve_segment(SplineKind kind, const Vec2* p, bool backwards_bezier);

// Solves polynomial(w) = 0 for 0 <= w <= 1, where polynomial is that coordinate minus value.
// Returns the count of roots.
int solve_coordinate(const CurveSegment& segment, int degree, int axis, double value, bool sturm,
                     double* roots);

}  // namespace durer
