// What triangles, smooth triangles and meshes share (spec/geometry.md 13.1, 13.2).
#pragma once

#include <cmath>
#include <utility>

#include "tracer/math/vector.h"

namespace durer {

// The two axes that a triangle is projected along its largest normal component to.
inline void projection_axes(const Vec3& normal, int& a, int& b) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  // Ties prefer later axes.
  if (x > y && x > z) {
    a = 1;
    b = 2;
  } else {
    a = 0;
    b = y > z ? 2 : 1;
  }
}

// Whether the first two vertices must be exchanged so that the edge tests below hold.
inline bool needs_exchange(const Vec3& p1, const Vec3& p2, const Vec3& p3, int a, int b) {
  return (p2[a] - p3[a]) * (p2[b] - p1[b]) < (p2[b] - p3[b]) * (p2[a] - p1[a]);
}

// The point is within all three edges, borders included, and as much beyond as `error`, by which
// its coordinates may be off.
inline bool covers(const Vec3& p1, const Vec3& p2, const Vec3& p3, int a, int b, double s, double t,
                   double error = 0) {
  const auto keeps = [&](const Vec3& from, const Vec3& to) {
    const double across = to[a] - from[a], up = to[b] - from[b];
    return (to[a] - s) * up - (to[b] - t) * across >= -error * (std::abs(across) + std::abs(up));
  };
  return keeps(p1, p2) && keeps(p2, p3) && keeps(p3, p1);
}

// The two numbers u, v with N = N1 + u (N2 - N1 + v (N3 - N2)) at a point of the triangle.
inline void smooth_weights(const Vec3& p1, const Vec3& p2, const Vec3& p3, const Vec3& p,
                           double& u, double& v) {
  const Vec3 edge = p3 - p2;
  const Vec3 size = glm::abs(edge);
  int axis = 0;
  if (size.y > size.x) axis = 1;
  if (size.z > size[axis]) axis = 2;
  // Perpendicular to the edge in the plane, 1 at p2 seen from p1.
  const Vec3 unit_edge = normalize_or_zero(edge);
  const Vec3 side = p2 - p1;
  Vec3 perpendicular = side - dot(side, unit_edge) * unit_edge;
  perpendicular /= dot(perpendicular, side);
  u = dot(p - p1, perpendicular);
  v = u < 1e-10 ? 0 : ((p[axis] - p1[axis]) / u + p1[axis] - p2[axis]) / edge[axis];
}

}  // namespace durer
