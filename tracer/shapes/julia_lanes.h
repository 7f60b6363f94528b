// Orbits of several points side by side. Chains of iterations leave a processor idle; eight of them do
// not. Each rounds like an orbit of its own.
#pragma once

#include "tracer/shapes/julia_maps.h"

namespace durer {

// The slice of the fourfold space that is seen, and how far its points are followed.
struct JuliaSlice {
  Vec4 normal;
  double distance;
  int iterations;
  double escape2;  // squares beyond have left

  // The point in fourfold space.
  Vec4 start(const Vec3& p) const {
    return {p.x, p.y, p.z,
            (distance - normal.x * p.x - normal.y * p.y - normal.z * p.z) / normal.w};
  }
};

// Points of the three-dimensional slice.
struct alignas(32) JuliaLanes {
  static constexpr int kCount = 8;

  double x[kCount], y[kCount], z[kCount];

  void set(int lane, const Vec3& p) {
    x[lane] = p.x;
    y[lane] = p.y;
    z[lane] = p.z;
  }
};

// A bit for each point: whether it is in the set.
unsigned lanes_in_set(const QuaternionSquare&, const JuliaSlice&, const JuliaLanes&);
unsigned lanes_in_set(const QuaternionCube&, const JuliaSlice&, const JuliaLanes&);

// Whether all points in a ball around each, of that radius in the fourfold space, are known to be in the
// set, however orbits round; for the lanes from the first one on until it is not known.
unsigned balls_in_set(const QuaternionSquare&, const JuliaSlice&, const JuliaLanes&, double radius);
unsigned balls_in_set(const QuaternionCube&, const JuliaSlice&, const JuliaLanes&, double radius);

}  // namespace durer
