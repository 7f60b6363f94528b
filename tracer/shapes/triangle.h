// What triangles, smooth triangles and meshes share (spec/geometry.md 13.1, 13.2).
#pragma once

#include <cmath>
#include <utility>

#include "tracer/math/vector.h"
#include "tracer/scene/shapes.h"

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

// The point is within all three edges, borders included.
inline bool covers(const Vec3& p1, const Vec3& p2, const Vec3& p3, int a, int b, double s,
                   double t) {
  const auto keeps = [&](const Vec3& from, const Vec3& to) {
    return (to[a] - s) * (to[b] - from[b]) - (to[b] - t) * (to[a] - from[a]) >= 0;
  };
  return keeps(p1, p2) && keeps(p2, p3) && keeps(p3, p1);
}

// In the triangle's plane, with dot(altitude, p - p1) = 0 at p1 and 1 on the edge p2 p3.
inline Vec3 altitude_of(const Vec3& p1, const Vec3& p2, const Vec3& p3) {
  const Vec3 unit_edge = unit_or_zero(p3 - p2);
  const Vec3 side = p1 - p3;
  const Vec3 across = unit_or_zero(dot(side, unit_edge) * unit_edge - side);
  return across * (-1 / dot(across, side));
}

// Of a mesh's triangle: in double precision as far as POV-Ray's is, and single precision then.
// Points of meshes are off their corners' planes by some 1e-7 of their size, and in the same way.
inline MeshPlane mesh_plane_of(const Vec3& p1, const Vec3& p2, const Vec3& p3) {
  const Vec3 unit = normalize_or_zero(cross(p3 - p1, p2 - p1));
  return {glm::vec3(unit), static_cast<float>(dot(unit, p1))};
}
inline MeshAltitude mesh_altitude_of(const Vec3& p1, const Vec3& p2, const Vec3& p3) {
  int a, b;
  projection_axes(normalize_or_zero(cross(p3 - p1, p2 - p1)), a, b);
  const bool exchange = needs_exchange(p1, p2, p3, a, b);
  const Vec3 &first = exchange ? p2 : p1, &second = exchange ? p1 : p2;
  const Vec3 unit_edge = normalize_or_zero(p3 - second);
  const Vec3 side = first - p3;
  glm::vec3 across(dot(side, unit_edge) * unit_edge - side);
  across *= 1 / std::sqrt(across.x * across.x + across.y * across.y + across.z * across.z);
  return {across * (-1 / static_cast<float>(dot(Vec3(across), side))), exchange};
}

// The two numbers u, v with N = N1 + u (N2 - N1 + v (N3 - N2)) at a point of the triangle.
inline void smooth_weights(const Vec3& p1, const Vec3& p2, const Vec3& p3, const Vec3& altitude,
                           const Vec3& p, double& u, double& v) {
  const Vec3 edge = p3 - p2;
  const Vec3 size = glm::abs(edge);
  // Ties prefer later axes.
  const int axis = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
  u = dot(p - p1, altitude);
  v = u < 1e-10 ? 0 : ((p[axis] - p1[axis]) / u + p1[axis] - p2[axis]) / edge[axis];
}

}  // namespace durer
