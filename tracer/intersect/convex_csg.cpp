// CSG of few convex solids and half spaces, the most usual kind: one sweep along the ray over where it
// crosses their surfaces, without asking for points inside (performance.md 4). In doubtful cases, where
// surfaces coincide or a crossing is missing, the general way decides (geometry.cpp).
#include <bit>
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

bool contains(const SweepPlan& plan, const SweptPart& part, uint32_t within);

bool all_others_contain(const SweepPlan& plan, const SweptPart& part, int32_t except,
                        uint32_t solids, uint32_t within) {
  if ((within & solids) != solids) return false;
  for (int32_t i = part.first_child; i >= 0; i = plan.parts[i].next) {
    if (i != except && !contains(plan, plan.parts[i], within)) return false;
  }
  return true;
}

bool any_other_contains(const SweepPlan& plan, const SweptPart& part, int32_t except,
                        uint32_t solids, uint32_t within) {
  if (within & solids) return true;
  for (int32_t i = part.first_child; i >= 0; i = plan.parts[i].next) {
    if (i != except && contains(plan, plan.parts[i], within)) return true;
  }
  return false;
}

// Whether a part contains a place that lies within the solids of these bits.
bool contains(const SweepPlan& plan, const SweptPart& part, uint32_t within) {
  return part.kind == NodeKind::intersection
             ? all_others_contain(plan, part, -1, part.solids, within)
             : any_other_contains(plan, part, -1, part.solids, within);
}

// Whether the surface of a solid (a bit), crossed at a place within some solids, is one of the whole.
bool is_on_surface(const SweepPlan& plan, uint32_t crossed, uint32_t within) {
  int32_t at = plan.part_of[std::countr_zero(crossed)], from = -1;
  for (uint32_t itself = crossed; at >= 0; itself = 0) {
    const SweptPart& part = plan.parts[at];
    const uint32_t others = part.solids & ~itself;
    // Surfaces within a union are seen, within a merge they are not.
    if (part.kind == NodeKind::intersection) {
      if (!all_others_contain(plan, part, from, others, within)) return false;
    } else if (part.kind == NodeKind::merge) {
      if (any_other_contains(plan, part, from, others, within)) return false;
    }
    from = at;
    at = part.parent;
  }
  return true;
}

}  // namespace

// Appends the solids of a CSG in the order of its tree; false if it has others, or too many.
bool Geometry::gather_convex_solids(uint32_t index, int32_t parent, std::vector<uint32_t>& solids,
                                    SweepPlan& plan) const {
  const GeometryNode& node = nodes[index];
  if (node.clips.count) return false;
  if (node.kind == NodeKind::shape) {
    const size_t number = solids.size();
    if (number == kMostIntersectedSolids || !node.shape->can_be_swept(node.inverted)) return false;
    if (number < kMostSweptSolids) plan.parts[parent].solids |= 1u << number;
    plan.part_of.push_back(parent);
    solids.push_back(index);
    return true;
  }
  if (node.kind == NodeKind::nothing) return false;
  if (node.tree >= 0 && (parent >= 0 || node.kind != NodeKind::intersection)) return false;
  // What cannot be swept by itself is no part of anything that can.
  if (parent >= 0 && node.kind != NodeKind::union_ && node.swept.count == 0) return false;
  const int32_t part = static_cast<int32_t>(plan.parts.size());
  plan.parts.push_back({node.kind, 0, parent, -1, -1});
  if (parent >= 0) {
    plan.parts[part].next = plan.parts[parent].first_child;
    plan.parts[parent].first_child = part;
  }
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const uint32_t child = lists[node.children.first + i];
    if (nodes[child].bounds.count) return false;
    // The solids of a hierarchy are its node's own children.
    if (node.tree >= 0 && nodes[child].kind != NodeKind::shape) return false;
    // Which members of a union take part may depend on the ray.
    if (node.kind != NodeKind::intersection && (nodes[child].hidden || !nodes[child].has_object)) {
      return false;
    }
    if (!gather_convex_solids(child, part, solids, plan)) return false;
  }
  return true;
}

Geometry::Sweep Geometry::sweep_convex_solids(const GeometryNode& node, const GeometryRay& ray,
                                              double t_max, HitStack& stack, ShapeHit& hit) const {
  const uint32_t* child = lists.data() + node.swept.first;
  const SweepPlan& plan = sweep_plans[child[node.swept.count]];
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
    if (crossing.t >= kLeastHitDepth && is_on_surface(plan, crossing.member, ~outside)) {
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
