// Where a ray enters and leaves an axis-parallel box, and by which faces (spec/geometry.md 12.2).
#pragma once

#include <cmath>

#include "tracer/shapes/shape.h"

namespace durer {

inline constexpr int kNoSide = 6;  // sides are 2·axis, +1 for the upper face

struct BoxCrossing {
  double near = 0, far = kHugeDepth;  // near: 0 where the origin is inside
  int entry = kNoSide, exit = kNoSide;
};

// Where two faces are met this close to each other, the one that the ray meets more squarely counts.
inline constexpr double kEdgeTolerance = 1e-6;

inline bool is_met_more_squarely(int axis, int side, const Vec3& steepness) {
  if (axis == 1) return steepness.y > steepness.x;
  return side != kNoSide && steepness.z > steepness[side / 2];
}

[[gnu::always_inline]] inline bool cross_box(const Vec3& low, const Vec3& high,
                                             const ShapeRay& ray, BoxCrossing& crossing) {
  auto& [near, far, entry, exit] = crossing;
  near = 0;
  far = kHugeDepth;
  entry = exit = kNoSide;
  const Vec3 steepness = glm::abs(ray.direction);
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis], o = ray.origin[axis];
    if (steepness[axis] <= kGeometryEpsilon) {
      if (o < low[axis] || o > high[axis]) return false;
      continue;
    }
    const int upper = d > 0 ? 1 : 0;
    const double t_far = ((upper ? high : low)[axis] - o) / d;
    if (t_far < near) return false;
    const double t_near = ((upper ? low : high)[axis] - o) / d;
    if (axis == 0) {
      if (t_far <= far) {
        exit = upper;
        far = t_far;
      }
      if (t_near >= near) {
        if (t_near > far) return false;
        entry = 1 - upper;
        near = t_near;
      }
      continue;
    }
    // On an edge the face met most squarely wins; y is always compared with x.
    if (t_far <= far - kEdgeTolerance) {
      exit = 2 * axis + upper;
      far = t_far;
    } else if (t_far <= far + kEdgeTolerance && is_met_more_squarely(axis, exit, steepness)) {
      exit = 2 * axis + upper;
    }
    if (t_near >= near + kEdgeTolerance) {
      if (t_near > far) return false;
      entry = 2 * axis + 1 - upper;
      near = t_near;
    } else if (t_near >= near - kEdgeTolerance && is_met_more_squarely(axis, entry, steepness)) {
      entry = 2 * axis + 1 - upper;
    }
  }
  return far >= kEdgeTolerance && exit != kNoSide;
}

}  // namespace durer
