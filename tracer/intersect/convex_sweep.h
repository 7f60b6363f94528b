// What the two sweeps along a ray through CSG of convex solids share.
#pragma once

#include <cstdint>

#include "tracer/shapes/shape.h"

namespace durer {

inline constexpr uint32_t kMostSweptSolids = 16;
// Where on the ray a sweep starts: before all hits that count.
inline constexpr double kSweepStart = 0.5 * kLeastHitDepth;
// Crossings of two solids closer than this share of their depth are doubtful.
inline constexpr double kSweepDoubt = 1e-7;

}  // namespace durer
