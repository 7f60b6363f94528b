#include "tracer/intersect/bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "tracer/intersect/bvh_build.h"
#include "tracer/intersect/bvh_walk.h"
#include "tracer/system/pages_ahead.h"

namespace durer {
namespace {

// Relative margin of the boxes: the ray's origin is rounded to single precision.
constexpr double kMargin = 2.5e-7;

// Of finite numbers.
float round_down(double x) {
  const float f = static_cast<float>(x);
  if (static_cast<double>(f) <= x) return f;
  if (f == 0) return -std::numeric_limits<float>::denorm_min();
  const uint32_t bits = std::bit_cast<uint32_t>(f);
  return std::bit_cast<float>(f > 0 ? bits - 1 : bits + 1);
}
float round_up(double x) { return -round_down(-x); }

}  // namespace

const bool kHasX86v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                       __builtin_cpu_supports("bmi2");

void Bvh::build(const std::vector<Bounds>& boxes) {
  Bounds all;
  for (const Bounds& box : boxes) all.extend(box);
  build(boxes.size(), all, [&](uint32_t i) { return boxes[i]; });
}

void Bvh::build(size_t count, const Bounds& bounds,
                const std::function<Bounds(uint32_t)>& box_of) {
  nodes_.clear();
  items_.clear();
  bounds_ = bounds;
  if (count == 0) return;
  center_ = bounds_.center();
  // Whatever is computed in single precision from points near the boxes errs by less than this.
  const Vec3 half = 0.5 * bounds_.size();
  const double margin = kMargin * std::max({half.x, half.y, half.z}) + 1e-30;
  reach_ = {bounds_.min - Vec3(4 * margin), bounds_.max + Vec3(4 * margin)};
  std::vector<BvhBuildItem> rounded;
  rounded.reserve(count);
  PagesAhead pages;
  for (uint32_t i = 0; i < count; ++i) {
    const Bounds box = box_of(i);
    BvhBuildItem item;
    item.item = i;
    for (int axis = 0; axis < 3; ++axis) {
      item.low[axis] = round_down(box.min[axis] - center_[axis] - margin);
      item.high[axis] = round_up(box.max[axis] - center_[axis] + margin);
    }
    pages.before_push(rounded);
    rounded.push_back(item);
  }
  nodes_.reserve(count / 4 + 1);
  build_bvh_nodes(rounded, nodes_, items_);
  rounded = {};
  // A copy to save little would need more than it saves.
  if (nodes_.capacity() - nodes_.size() > nodes_.size() / 2) nodes_.shrink_to_fit();
}

}  // namespace durer
