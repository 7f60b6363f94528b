// The sources of ripples and waves (spec/textures.md 2.8) and the cycle that POV-Ray's waves run
// through.
#pragma once

#include <cmath>
#include <vector>

#include "tracer/math/vector.h"

namespace durer {

struct WaveSource {
  Vec3 center;
  double frequency;
};

// count >= 1.
std::vector<WaveSource> wave_sources(int count);

// sin(2 pi frac(v)), odd in v.
inline double cycle(double v) {
  return v >= 0 ? std::sin(2 * M_PI * (v - std::floor(v)))
                : -std::sin(2 * M_PI * (-v - std::floor(-v)));
}

}  // namespace durer
