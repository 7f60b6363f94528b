// The question that every light-transport method answers: what light comes back along this ray?
#pragma once

#include "tracer/scene/color.h"
#include "tracer/shading/ray_state.h"

namespace durer {

// Radiance along a ray and how much of the background shows through (0: opaque).
struct RayResult {
  RGB color{0.0f};
  float transmit = 0;
  double depth = kFarAway;  // distance of the first hit
};

// Counts of one thread; summed after rendering.
struct RayCounts {
  uint64_t primary = 0, reflected = 0, refracted = 0, shadow = 0, total_internal = 0;
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  // Thread-safe; counts belong to the calling thread.
  virtual RayResult trace(const TracedRay& ray, RayCounts& counts) const = 0;
};

}  // namespace durer
