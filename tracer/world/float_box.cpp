#include "tracer/world/float_box.h"

#include <algorithm>

namespace durer {

FloatBox FloatBox::from(const Bounds& bounds) {
  FloatBox box;
  for (int i = 0; i < 3; ++i) {
    const double low = std::max(bounds.min[i], -kUnboundedExtent);
    const double high = std::min(bounds.max[i], kUnboundedExtent);
    box.lower[i] = static_cast<float>(low);
    box.length[i] = static_cast<float>(high - low);
  }
  return box;
}

Bounds FloatBox::to_bounds() const {
  Bounds bounds;
  for (int i = 0; i < 3; ++i) {
    bounds.min[i] = static_cast<double>(lower[i]);
    bounds.max[i] = static_cast<double>(lower[i] + length[i]);
  }
  return bounds;
}

FloatBox FloatBox::transformed(const Transform& transform) const {
  Bounds result;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      p[i] = static_cast<double>(corner & (1 << i) ? lower[i] + length[i] : lower[i]);
    }
    result.extend(transform.point(p));
  }
  for (int i = 0; i < 3; ++i) {
    result.min[i] = std::max(result.min[i], -kUnboundedExtent);
    result.max[i] = std::min(result.max[i], kUnboundedExtent);
  }
  return from(result);
}

bool FloatBox::contains(const Vec3& p) const {
  for (int i = 0; i < 3; ++i) {
    if (p[i] < static_cast<double>(lower[i]) ||
        p[i] > static_cast<double>(lower[i] + length[i])) {
      return false;
    }
  }
  return true;
}

}  // namespace durer
