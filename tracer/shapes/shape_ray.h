// A ray as shapes see it, and the depths that count (spec/geometry.md 1).
#pragma once

#include "tracer/math/vector.h"

namespace durer {

inline constexpr double kGeometryEpsilon = 1e-10;
inline constexpr double kLeastHitDepth = 1e-4;   // of an accepted nearest hit, world distance
inline constexpr double kGreatestDepth = 1e7;    // of most shapes
inline constexpr double kHugeDepth = 2e10;       // where searches start

// A ray in a shape's space. Parameters are world distances: the direction is not renormalised.
struct ShapeRay {
  Vec3 origin;
  Vec3 direction;
  bool unit_direction = false;  // known to be of length 1
  bool csg_child = false;       // all hits are needed; otherwise a shape may stop at its first
  double t_max = kHugeDepth;    // hits from here on are of no interest (a hint)
  bool is_clipped = false;      // any hit may be clipped away
};

}  // namespace durer
