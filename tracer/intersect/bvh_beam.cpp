// Rays of one pixel meet nearly the same boxes: a walk through the hierarchy with intervals of
// origins and directions (as in Boulos, Wald, Shirley 2006, "Geometric and arithmetic culling methods
// for entire ray packets") finds the few subtrees that any of them may meet.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/intersect/bvh_walk.h"

namespace durer {
namespace {

// Smaller hierarchies are walked as fast as a beam is.
constexpr size_t kLeastNodes = 1000;
// With so many leaves on the way the subtrees behind them stay whole.
constexpr int kEnoughLeaves = 8;
constexpr int kMostEntries = 8 * BvhBeam::kGroups;

// The rays' origins and inverse directions as BvhWalk has them: both bounds of each.
struct RaySpan {
  float origin[2][3], inverse[2][3];
  float limit;

  void extend(const BvhWalk& walk, float walk_limit) {
    for (int axis = 0; axis < 3; ++axis) {
      origin[0][axis] = std::min(origin[0][axis], walk.origin[axis]);
      origin[1][axis] = std::max(origin[1][axis], walk.origin[axis]);
      inverse[0][axis] = std::min(inverse[0][axis], walk.inverse[axis]);
      inverse[1][axis] = std::max(inverse[1][axis], walk.inverse[axis]);
    }
    limit = std::max(limit, walk_limit);
  }
  // All go the same way along each axis, none stands still.
  bool is_bundle() const {
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(inverse[0][axis]) || !std::isfinite(inverse[1][axis]) ||
          std::signbit(inverse[0][axis]) != std::signbit(inverse[1][axis])) {
        return false;
      }
    }
    return true;
  }
};

struct BeamEntry {
  const BvhNode* node;
  int slot;
  float near;
};

}  // namespace

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
namespace base_walk {
namespace {
#define DURER_WALK_TARGET
#include "tracer/intersect/bvh_beam.inc"
#undef DURER_WALK_TARGET
}  // namespace
}  // namespace base_walk
namespace v3_walk {
namespace {
#define DURER_WALK_TARGET __attribute__((target("arch=x86-64-v3")))
#include "tracer/intersect/bvh_beam.inc"
#undef DURER_WALK_TARGET
}  // namespace
}  // namespace v3_walk
#pragma GCC diagnostic pop

bool Bvh::make_beam(const Ray* rays, int count, double t_max, BvhBeam& beam) const {
  if (nodes_.size() < kLeastNodes) return false;
  beam.groups = 0;
  RaySpan span;
  bool is_first = true;
  for (int i = 0; i < count; ++i) {
    BvhWalk walk;
    if (!start_walk(BvhRay(rays[i].origin, rays[i].direction), t_max, walk)) continue;
    if (is_first) {
      for (auto& bound : span.origin) std::copy_n(walk.origin, 3, bound);
      for (auto& bound : span.inverse) std::copy_n(walk.inverse, 3, bound);
      span.limit = walk.limit(t_max);
    }
    span.extend(walk, walk.limit(t_max));
    is_first = false;
  }
  if (is_first) return true;
  if (!span.is_bundle()) return false;

  BeamEntry entries[kMostEntries];
  const int found = kHasX86v3 ? v3_walk::collect(nodes_.data(), span, entries)
                              : base_walk::collect(nodes_.data(), span, entries);
  beam.groups = (found + 7) / 8;
  for (int g = 0; g < beam.groups; ++g) {
    BvhNode& group = beam.group[g];
    const int size = std::min(8, found - 8 * g);
    group.used = (1u << size) - 1;
    for (int i = 0; i < size; ++i) {
      const BeamEntry& entry = entries[8 * g + i];
      group.child[i] = entry.node->child[entry.slot];
      for (int axis = 0; axis < 3; ++axis) {
        group.low[axis][i] = entry.node->low[axis][entry.slot];
        group.high[axis][i] = entry.node->high[axis][entry.slot];
      }
    }
    // What no child fills must be numbers.
    for (int i = size; i < 8; ++i) {
      for (int axis = 0; axis < 3; ++axis) group.low[axis][i] = group.high[axis][i] = 0;
    }
  }
  float nearest = std::numeric_limits<float>::infinity();
  for (int i = found - 1; i >= 0; --i) {
    nearest = std::min(nearest, entries[i].near);
    if (i % 8 == 0) beam.near[i / 8] = nearest;
  }
  return true;
}

}  // namespace durer
