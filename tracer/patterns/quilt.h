// What quilted is made of, as a pattern and as a normal (spec/textures.md 6, 14.1).
#pragma once

#include <cmath>

#include "tracer/math/vector.h"

namespace durer {

// The whole number below; povray takes the next lower one of those that are negative and whole.
inline double whole_below(double x) {
  const double whole = std::floor(x);
  return whole == x && x < 0 ? whole - 1 : whole;
}

// From the centre of the unit cube around a point to the point, times a cubic of its distance whose
// inner Bernstein coefficients are the controls. In povray's order of operations.
inline Vec3 quilt(const Vec3& p, double control0, double control1) {
  const Vec3 w = p - Vec3(whole_below(p.x), whole_below(p.y), whole_below(p.z)) - Vec3(0.5);
  const double t = length(w), u = 1 - t, t2 = t * t, u2 = u * u;
  const double cubic = t2 * t + 3 * t * u2 * control0 + 3 * t2 * u * control1;
  return (1.154700538 * cubic) * w;
}

}  // namespace durer
