// Axis-aligned boxes in double. Empty boxes have min > max; unbounded ones reach kUnboundedExtent.
#pragma once

#include <algorithm>

#include "tracer/math/vector.h"

namespace durer {

// POV-Ray calls an object infinite when a side of its box exceeds this (spec/geometry.md).
inline constexpr double kUnboundedExtent = 1e10;

struct Bounds {
  Vec3 min{kUnboundedExtent};
  Vec3 max{-kUnboundedExtent};

  static Bounds everything() { return {Vec3(-kUnboundedExtent), Vec3(kUnboundedExtent)}; }

  bool is_empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
  bool is_bounded() const {
    const Vec3 size = max - min;
    return size.x < kUnboundedExtent && size.y < kUnboundedExtent && size.z < kUnboundedExtent;
  }
  Vec3 center() const { return 0.5 * (min + max); }
  Vec3 size() const { return max - min; }
  bool contains(const Vec3& p) const {
    return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z &&
           p.z <= max.z;
  }
  void extend(const Vec3& p) {
    min = Vec3(std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z));
    max = Vec3(std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z));
  }
  void extend(const Bounds& b) {
    if (b.is_empty()) return;
    extend(b.min);
    extend(b.max);
  }
  void clip(const Bounds& b) {
    min = Vec3(std::max(min.x, b.min.x), std::max(min.y, b.min.y), std::max(min.z, b.min.z));
    max = Vec3(std::min(max.x, b.max.x), std::min(max.y, b.max.y), std::min(max.z, b.max.z));
  }
};

}  // namespace durer
