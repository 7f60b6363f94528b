// The brightness that image_pattern and pigment_pattern make of a colour.
#pragma once

#include "tracer/scene/color.h"

namespace durer {

// Summed in double and kept in single precision, as POV-Ray does it (spec/textures.md 1).
inline float pattern_grey(const ColorRGBFT& c) {
  return static_cast<float>(0.297 * static_cast<double>(c.red) +
                            0.589 * static_cast<double>(c.green) +
                            0.114 * static_cast<double>(c.blue));
}

}  // namespace durer
