#include "tracer/shapes/parametric_bounds.h"

#include <algorithm>
#include <cmath>

namespace durer {
namespace {

// A range that encloses a function between two values, from its greatest slope. It is no number where
// a value is none, both are infinite, or the slope is 0, which povray divides by: no ray hits there.
CoordinateRange enclose(double gradient, double width, double p, double q) {
  double overshoot = 0.5 * gradient * (width - std::abs(p - q) / gradient);
  if (overshoot < 0) overshoot = 0;
  return {std::min(p, q) - overshoot, std::max(p, q) + overshoot};
}

std::pair<ParameterRectangle, ParameterRectangle> halves_of(const ParameterRectangle& r) {
  const double middle = r.middle();
  if (r.splits_u()) return {{r.u0, middle, r.v0, r.v1}, {middle, r.u1, r.v0, r.v1}};
  return {{r.u0, r.u1, r.v0, middle}, {r.u0, r.u1, middle, r.v1}};
}

}  // namespace

Corners ParametricCoordinate::corners(const ParameterRectangle& r) const {
  const ParametricCoordinate& f = *this;
  return {f(r.u0, r.v0), f(r.u0, r.v1), f(r.u1, r.v0), f(r.u1, r.v1)};
}

std::pair<Corners, Corners> ParametricCoordinate::halves(const ParameterRectangle& r,
                                                         const Corners& whole) const {
  const ParametricCoordinate& f = *this;
  const double middle = r.middle();
  Corners low = whole, high = whole;
  if (r.splits_u()) {
    low[2] = high[0] = f(middle, r.v0);
    low[3] = high[1] = f(middle, r.v1);
  } else {
    low[1] = high[0] = f(r.u0, middle);
    low[3] = high[2] = f(r.u1, middle);
  }
  return {low, high};
}

CoordinateRange ParametricCoordinate::estimate(const ParameterRectangle& r, const Corners& f) const {
  const double a = accuracy_, g = max_gradient_;
  const CoordinateRange left = enclose(g, r.v1 - r.v0, f[0] - a, f[1] - a);
  const CoordinateRange right = enclose(g, r.v1 - r.v0, f[2] - a, f[3] - a);
  return {enclose(g, r.u1 - r.u0, left.low, right.low).low,
          enclose(g, r.u1 - r.u0, left.high, right.high).high};
}

PrecomputedBounds::PrecomputedBounds(const ParametricCoordinate& coordinate,
                                     const ParameterRectangle& root, int depth,
                                     double least_side) {
  int kept = 1;
  for (ParameterRectangle r = root;
       kept < depth && std::max(r.u1 - r.u0, r.v1 - r.v0) >= least_side; r = halves_of(r).first)
    ++kept;
  bounds_.resize(size_t{1} << kept);
  compute(coordinate, root, coordinate.corners(root), 1, depth);
}

CoordinateRange PrecomputedBounds::compute(const ParametricCoordinate& coordinate,
                                    const ParameterRectangle& r, const Corners& corners,
                                    uint32_t number, int depth) {
  CoordinateRange result;
  if (depth == 1) {
    result = coordinate.estimate(r, corners);
  } else {
    const auto [low, high] = halves_of(r);
    const auto [low_corners, high_corners] = coordinate.halves(r, corners);
    const CoordinateRange a = compute(coordinate, low, low_corners, 2 * number, depth - 1);
    const CoordinateRange b = compute(coordinate, high, high_corners, 2 * number + 1, depth - 1);
    // The upper half's where either is no number, as in povray.
    result = {std::min(b.low, a.low), std::max(b.high, a.high)};
  }
  if (number < bounds_.size()) bounds_[number] = result;
  return result;
}

}  // namespace durer
