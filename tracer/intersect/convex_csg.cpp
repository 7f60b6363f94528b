// CSG of few convex solids and half spaces, the most usual kind: one sweep along the ray over where it
// crosses their surfaces, without asking for points inside (performance.md 4). In doubtful cases, where
// surfaces coincide or a crossing is missing, the general way decides (geometry.cpp).
#include <cmath>

#include "tracer/intersect/convex_sweep.h"
#include "tracer/intersect/geometry.h"

namespace durer {
namespace {

struct Crossing {
  double t;
  uint32_t member;    // bit
  uint32_t position;  // in the stack
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
    return solids.size() <= kMostSweptSolids &&
           (node.shape->is_convex_solid() || node.shape->is_half_space());
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
  const size_t base = stack.size();
  const auto give_back = [&](Sweep result) {
    stack.shrink(base);
    return result;
  };
  Crossings crossings;
  uint32_t outside = 0;  // members whose solids the sweep is not in
  for (uint32_t i = 0; i < node.swept.count; ++i) {
    const GeometryNode& member = nodes[child[i]];
    const uint32_t bit = 1u << i;
    double low = kSweepStart, high = t_max;
    if (member.is_boxed) ray.clip(member.reach, low, high);
    const size_t first = stack.size();
    if (low <= high * (1 + 1e-12)) {
      stack.owner = child[i];
      ShapeRay local = shape_ray(ray, member.transform < 0 ? nullptr : &transforms[member.transform]);
      local.csg_child = true;
      member.shape->hits(local, stack);
      stack.count_test(member.shape_kind, stack.size() > first);
    }
    const size_t count = stack.size() - first;
    // Where the sweep starts.
    const auto starts_inside = [&] {
      const Vec3 start = ray.origin + kSweepStart * ray.direction;
      return member.shape->inside(member.transform < 0
                                      ? start
                                      : transforms[member.transform].inverse_point(start));
    };
    bool inside = false;
    if (!member.is_half_space) {
      if (count > 2) return give_back(Sweep::doubtful);
      if (count == 2) {
        inside = (stack[first].t > kSweepStart) != (stack[first + 1].t > kSweepStart);
      } else if (count == 1) {
        // Where the ray leaves, unless rounding took the other crossing.
        inside = stack[first].t > kSweepStart;
        if (!inside || !starts_inside()) return give_back(Sweep::doubtful);
      }
    } else {
      inside = starts_inside();
    }
    const bool in_solid = inside != member.inverted;
    if (!in_solid) outside |= bit;
    for (size_t k = first; k < stack.size(); ++k) {
      if (stack[k].t > kSweepStart) crossings.add({stack[k].t, bit, static_cast<uint32_t>(k)});
    }
  }

  const Crossing* before = nullptr;
  for (const Crossing& crossing : crossings) {
    if (before && before->member != crossing.member &&
        crossing.t - before->t <= kSweepDoubt * (1 + crossing.t)) {
      return give_back(Sweep::doubtful);
    }
    before = &crossing;
    const bool shows =
        crossing.t >= kLeastHitDepth && is_on_surface(node, crossing.member, ~outside);
    if (shows && crossing.t >= t_max) return give_back(Sweep::missed);
    if (shows) {
      const Crossing* next = &crossing + 1;
      if (next != crossings.end() && next->member != crossing.member &&
          next->t - crossing.t <= kSweepDoubt * (1 + crossing.t)) {
        return give_back(Sweep::doubtful);
      }
      hit = stack[crossing.position];
      return give_back(Sweep::met);
    }
    outside ^= crossing.member;
  }
  return give_back(Sweep::missed);
}

}  // namespace durer
