// The angle around y that uv mapping uses (spec/geometry.md 8).
#pragma once

#include <cmath>

namespace durer {

// In [0, 2π): 0 on the +x side, growing towards +z; 0 on the axis itself.
inline double spherical_angle(double x, double z) {
  const double squared = x * x + z * z;
  if (squared <= 1e-10) return 0;
  if (z == 0) return x > 0 ? 0 : M_PI;
  const double angle = std::acos(x / std::sqrt(squared));
  return z < 0 ? 2 * M_PI - angle : angle;
}

}  // namespace durer
