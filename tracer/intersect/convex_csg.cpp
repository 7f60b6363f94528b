// CSG of few convex solids and half spaces, the most usual kind: one sweep along the ray over where it
// crosses their surfaces, without asking for points inside (performance.md 4). In doubtful cases, where
// surfaces coincide or a crossing is missing, the general way decides (geometry.cpp).
#include <cmath>

#include "tracer/intersect/convex_sweep.h"

namespace durer {
namespace {

struct Crossing {
  double t;
  uint32_t member;  // bit
  uint32_t node;
  uint32_t part;
};

// In the order of their depths.
class Crossings {
 public:
  void add(const Crossing& crossing) {
    int place = count_++;
    while (place > 0 && crossing_[place - 1].t > crossing.t) {
      crossing_[place] = crossing_[place - 1];
      --place;
    }
    crossing_[place] = crossing;
  }
  const Crossing* begin() const { return crossing_; }
  const Crossing* end() const { return crossing_ + count_; }

 private:
  Crossing crossing_[2 * kMostSweptSolids];
  int count_ = 0;
};

// What is known of a part of a CSG where the ray crosses the surface of one of its solids.
struct PartState {
  bool contains = false;    // the place, but for the side of the crossed surface
  bool is_crossed = false;  // the crossed solid is a part of it
  bool shows = false;       // then: the crossing is on its surface
};

// `solid` is the bit of the next solid in the order of gather_convex_solids().
PartState part_state(const Geometry& geometry, const GeometryNode& node, uint32_t crossed,
                     uint32_t within, uint32_t& solid) {
  if (node.kind == NodeKind::shape) {
    const uint32_t bit = solid;
    solid <<= 1;
    return {(within & bit) != 0, bit == crossed, bit == crossed};
  }
  const uint32_t* child = geometry.lists.data() + node.children.first;
  PartState whole;
  bool all = true, any = false;
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const PartState part = part_state(geometry, geometry.nodes[child[i]], crossed, within, solid);
    if (part.is_crossed) {
      whole.is_crossed = true;
      whole.shows = part.shows;
    } else {
      all &= part.contains;
      any |= part.contains;
    }
  }
  if (node.kind == NodeKind::intersection) {
    whole.shows &= all;
    whole.contains = all;
  } else {
    // Surfaces within a union are seen, within a merge they are not.
    if (node.kind == NodeKind::merge) whole.shows &= !any;
    whole.contains = any;
  }
  return whole;
}

}  // namespace

// Appends the solids of a CSG in the order of its tree; false if it has others, or too many.
bool Geometry::gather_convex_solids(uint32_t index, std::vector<uint32_t>& solids,
                                    bool& is_flat) const {
  const GeometryNode& node = nodes[index];
  if (node.clips.count) return false;
  if (node.kind == NodeKind::shape) {
    solids.push_back(index);
    return solids.size() <= kMostSweptSolids && node.shape->can_be_swept(node.inverted);
  }
  if (node.kind == NodeKind::nothing || node.tree >= 0) return false;
  is_flat &= node.kind == NodeKind::intersection;
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const uint32_t child = lists[node.children.first + i];
    if (nodes[child].bounds.count) return false;
    // Which members of a union take part may depend on the ray.
    if (node.kind != NodeKind::intersection && (nodes[child].hidden || !nodes[child].has_object)) {
      return false;
    }
    if (!gather_convex_solids(child, solids, is_flat)) return false;
  }
  return true;
}

// Whether a crossing of one solid's surface is one of the node's, at a place within some solids.
bool Geometry::is_on_surface(const GeometryNode& node, uint32_t crossed, uint32_t within) const {
  uint32_t first = 1;
  return part_state(*this, node, crossed, within, first).shows;
}

Geometry::Sweep Geometry::sweep_convex_solids(const GeometryNode& node, const GeometryRay& ray,
                                              double t_max, HitStack& stack, ShapeHit& hit) const {
  const uint32_t* child = lists.data() + node.swept.first;
  Crossings crossings;
  uint32_t outside = 0;  // members whose solids the sweep is not in
  for (uint32_t i = 0; i < node.swept.count; ++i) {
    const GeometryNode& member = nodes[child[i]];
    const uint32_t bit = 1u << i;
    SweptSolid solid(*this, member, ray);
    solid.find_crossings(kSweepStart, t_max, true, stack);
    const LineHits& met = solid.crossings;
    bool inside = false;
    if (member.is_half_space) {
      inside = solid.holds_start();
    } else {
      if (met.count > 2) return Sweep::doubtful;
      if (met.count == 2) {
        inside = (met.t[0] > kSweepStart) != (met.t[1] > kSweepStart);
      } else if (met.count == 1) {
        // Where the ray leaves, unless rounding took the other crossing.
        inside = met.t[0] > kSweepStart;
        if (!inside || !solid.holds_start()) return Sweep::doubtful;
      }
    }
    if (inside == member.inverted) outside |= bit;
    for (int k = 0; k < met.count; ++k) {
      if (met.t[k] > kSweepStart) crossings.add({met.t[k], bit, child[i], met.part[k]});
    }
  }

  const auto are_near = [](const Crossing& first, const Crossing& second) {
    return first.member != second.member &&
           second.t - first.t <= kSweepDoubt * (1 + second.t);
  };
  const Crossing* before = nullptr;
  for (const Crossing& crossing : crossings) {
    if (before && are_near(*before, crossing)) return Sweep::doubtful;
    before = &crossing;
    if (crossing.t >= kLeastHitDepth && is_on_surface(node, crossing.member, ~outside)) {
      if (crossing.t >= t_max) return Sweep::missed;
      const Crossing* next = &crossing + 1;
      if (next != crossings.end() && are_near(crossing, *next)) return Sweep::doubtful;
      hit = {crossing.t, crossing.node, crossing.part, 0, 0};
      return Sweep::met;
    }
    outside ^= crossing.member;
  }
  return Sweep::missed;
}

}  // namespace durer
