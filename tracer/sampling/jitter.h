// POV-Ray's table-driven jitter of sub-pixel samples: a function of place (spec/shading.md 2.2).
#pragma once

#include "tracer/math/vector.h"

namespace durer {

// Offset in [-0.5, 0.5) per axis for the sample at pixel coordinates (x, y), where integers are
// pixel centres.
Vec2 sample_jitter(double x, double y);

}  // namespace durer
