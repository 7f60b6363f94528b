#include "tracer/intersect/float_box.h"

#include <algorithm>
#include <cmath>

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

Bounds FloatBox::to_double_bounds() const {
  Bounds bounds;
  for (int i = 0; i < 3; ++i) {
    bounds.min[i] = static_cast<double>(lower[i]);
    bounds.max[i] = bounds.min[i] + static_cast<double>(length[i]);
  }
  return bounds;
}

FloatBox FloatBox::transformed(const Transform& transform) const {
  Bounds result;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      p[i] =
          static_cast<double>(lower[i]) + (corner & (1 << i) ? static_cast<double>(length[i]) : 0);
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
    if (p[i] < static_cast<double>(lower[i]) || p[i] > static_cast<double>(lower[i] + length[i])) {
      return false;
    }
  }
  return true;
}

bool FloatBox::is_met(const Vec3& origin, const Vec3& direction, bool in_x_face) const {
  float enter = 0, leave = 2e10f;
  for (int axis = 0; axis < 3; ++axis) {
    const float o = static_cast<float>(origin[axis]);
    const float inverse = 1 / static_cast<float>(direction[axis]);
    const float low = lower[axis], high = low + length[axis];
    const float near = ((inverse < 0 ? high : low) - o) * inverse;
    const float far = ((inverse < 0 ? low : high) - o) * inverse;
    // 0 times infinity: in the plane of a face.
    if (axis == 0 && !in_x_face && (std::isnan(near) || std::isnan(far))) return false;
    if (near > leave || far < enter) return false;
    enter = near > enter ? near : enter;
    leave = far < leave ? far : leave;
  }
  return leave > 1e-4f;
}

}  // namespace durer
