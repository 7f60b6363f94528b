// The walks through a Bvh, with the visitors built in: for any x86-64 and for x86-64-v3, chosen at run
// time; both give the same bits. (Functions of a target attribute, not a source compiled for v3: what
// is inline in other headers must not be compiled for the newer processors, the linker could keep
// that copy for all.)
#pragma once

#include <bit>
#include <cstdint>
#include <utility>

#include "tracer/intersect/bvh_beam.h"

namespace durer {

// A ray as the walk sees it, in single precision.
struct BvhWalk {
  // Errors of the slab test: three roundings per distance.
  static constexpr float kWiden = 1.0f + 4e-7f;

  float origin[3];   // relative to the centre of the hierarchy
  float inverse[3];  // of the direction; infinite where that is 0
  double t_offset;   // what the true origin lies before `origin`

  // What boxes must be entered before.
  float limit(double t_max) const { return static_cast<float>(t_max - t_offset) * kWiden; }
};

// A child that waits for its turn, and where the ray enters it.
class BvhWaiting {
 public:
  BvhWaiting() {}
  // near >= 0: then bits are in the order of the numbers. One word, because loads of two halves
  // that were just stored wait for both.
  BvhWaiting(uint32_t child, float near)
      : word_(static_cast<uint64_t>(std::bit_cast<uint32_t>(near)) << 32 | child) {}
  explicit BvhWaiting(uint32_t child) : word_(child) {}

  uint32_t child() const { return static_cast<uint32_t>(word_); }
  float near() const { return std::bit_cast<float>(static_cast<uint32_t>(word_ >> 32)); }
  bool is_nearer_than(const BvhWaiting& other) const { return word_ >> 32 < other.word_ >> 32; }

 private:
  uint64_t word_;
};
inline constexpr int kBvhStack = 8 * 64;

extern const bool kHasX86v3;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
namespace base_walk {
#define DURER_WALK_TARGET
#define DURER_WALK_HAS_AVX 0
#include "tracer/intersect/bvh_walk.inc"
#undef DURER_WALK_TARGET
#undef DURER_WALK_HAS_AVX
}  // namespace base_walk
namespace v3_walk {
#define DURER_WALK_TARGET __attribute__((target("arch=x86-64-v3")))
#define DURER_WALK_HAS_AVX 1
#include "tracer/intersect/bvh_walk.inc"
#undef DURER_WALK_TARGET
#undef DURER_WALK_HAS_AVX
}  // namespace v3_walk
#pragma GCC diagnostic pop

// False: the ray passes by the whole hierarchy.
[[gnu::always_inline]] inline bool Bvh::start_walk(const BvhRay& ray, double t_max, BvhWalk& walk) const {
  // Clip to the whole in double, and start there: far origins would lose their digits.
  double enter = 0, leave = t_max;
  if (!reach_.contains(ray.origin)) {
    ray.clip(reach_, enter, leave);
    if (!(enter <= leave * (1 + 1e-12))) return false;
  }
  walk.t_offset = enter;
  for (int axis = 0; axis < 3; ++axis) {
    walk.origin[axis] =
        static_cast<float>(ray.origin[axis] + enter * ray.direction[axis] - center_[axis]);
    walk.inverse[axis] = static_cast<float>(ray.inverse[axis]);
  }
  return true;
}

template <bool kAnyOrder, typename Visitor>
void Bvh::visit_ray(const BvhRay& ray, double t_max, Visitor&& visit) const {
  BvhWalk walk;
  if (nodes_.empty() || !start_walk(ray, t_max, walk)) return;
  const BvhNode* nodes = nodes_.data();
  kHasX86v3 ? v3_walk::walk_ray<kAnyOrder>(nodes, *nodes, walk, t_max, visit)
            : base_walk::walk_ray<kAnyOrder>(nodes, *nodes, walk, t_max, visit);
}

template <typename Visitor>
void Bvh::visit_beam_ray(const BvhBeam& beam, const BvhRay& ray, double t_max,
                         Visitor&& visit) const {
  BvhWalk walk;
  if (beam.groups == 0 || !start_walk(ray, t_max, walk)) return;
  const BvhNode* nodes = nodes_.data();
  for (int i = 0; i < beam.groups; ++i) {
    if (i > 0 && beam.near[i] > walk.limit(t_max)) return;
    const bool ended = kHasX86v3 ? v3_walk::walk_ray<false>(nodes, beam.group[i], walk, t_max, visit)
                                 : base_walk::walk_ray<false>(nodes, beam.group[i], walk, t_max, visit);
    if (ended) return;
  }
}

template <typename Visitor>
void Bvh::visit_point(const Vec3& point, Visitor&& visit) const {
  if (nodes_.empty()) return;
  float local[3];
  for (int axis = 0; axis < 3; ++axis) {
    local[axis] = static_cast<float>(point[axis] - center_[axis]);
  }
  kHasX86v3 ? v3_walk::walk_point(nodes_.data(), local, visit)
            : base_walk::walk_point(nodes_.data(), local, visit);
}

}  // namespace durer
