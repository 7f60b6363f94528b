// What one ray looks for among the objects of a level: the nearest hit, or anything that stops light.
#pragma once

#include <cmath>

#include "tracer/intersect/bvh_walk.h"
#include "tracer/world/shadow_casters.h"
#include "tracer/world/world_builder.h"

namespace durer {

// Of two depths that differ by less than this share the lesser one need not count: the walk may end
// before it, where boxes are met with single precision.
inline constexpr double kNearlySame = 1e-6;

inline bool meets_box(const TopLevelObject& object, const GeometryRay& ray) {
  return object.asks_box ? object.box.is_met(ray.origin, ray.direction)
                         : object.box.is_met_in_hierarchy(ray.origin, ray.direction);
}

// Rays in the plane of a box's face across x do not see what is in the box.
inline bool slips_along_box(const TopLevelObject& object, const GeometryRay& ray) {
  return ray.direction.x == 0 && object.asks_box && !meets_box(object, ray);
}

// The nearest of a node's hits behind `least`, as far as POV-Ray lists them all. The node is not a copy.
inline bool find_beyond(const Geometry& geometry, uint32_t index, const GeometryRay& ray, double least,
                 HitStack& stack, ShapeHit& hit) {
  const GeometryNode& node = geometry.nodes[index];
  if (node.kind == NodeKind::shape && !node.csg_child && node.clips.count == 0 &&
      node.shape->ends_at_nearest_hit()) {
    return false;
  }
  const size_t base = stack.size();
  geometry.all_hits(index, ray, {least, ray.t_max}, stack);
  bool found = false;
  for (size_t i = base; i < stack.size(); ++i) {
    const ShapeHit& other = stack[i];
    if (other.t > least && other.t < ray.t_max && !(found && other.t > hit.t)) {
      hit = other;
      found = true;
    }
  }
  stack.shrink(base);
  return found;
}

// The nearest hit among the objects of one list.
struct ClosestSearch {
  ClosestSearch(const WorldData& world, const ObjectSet& objects, const SearchList& wanted,
                GeometryRay& along, HitStack& scratch, double t_max)
      : data(world), set(objects), list(wanted), ray(along), stack(scratch), limit(t_max),
        best(t_max) {
    ray.t_max = t_max;
  }

  const WorldData& data;
  const ObjectSet& set;
  const SearchList& list;
  GeometryRay& ray;  // hits must be nearer than its t_max
  HitStack& stack;
  const double limit;
  double best;
  // The nearest so far, where top is not negative, and room for the next: copies of what was just
  // written by components would wait for them.
  ShapeHit hits[2];
  int nearest = 0;
  int64_t top = -1;
  uint32_t instance = 0;
  double least = 0;  // hits up to this depth do not count

  void run(const BvhBeam* beam = nullptr) {
    for (const SearchItem& item : list.infinite) test(item);
    if (list.is_scanned) {
      for (const SearchItem& item : list.finite) test(item);
      return;
    }
    const auto test_leaf = [this](uint32_t first, uint32_t count, double& t_max) {
      const SearchItem* item = list.finite.data() + first;
      for (const SearchItem* end = item + count; item < end; ++item) test(*item);
      t_max = ray.t_max;
      return false;
    };
    if (beam) {
      list.bvh.visit_beam_ray(*beam, ray, best, test_leaf);
    } else {
      list.bvh.visit_ray(ray, best, test_leaf);
    }
  }

  void test(const SearchItem& item) {
    if (item.hidden & ray.kind) return;
    ShapeHit& candidate = hits[1 - nearest];
    uint32_t copy = 0;
    if (item.shape) [[likely]] {
      if (!meets_shape(item, candidate)) return;
    } else if (!meets_other(set.objects[item.object], candidate, copy)) {
      return;
    }
    if (candidate.t <= least && !find_beyond(data.geometry, item.node, ray, least, stack,
                                             candidate)) [[unlikely]]
      return;
    if (slips_along_box(set.objects[item.object], ray)) [[unlikely]]
      return;
    if (top >= 0 && candidate.t > best * (1 - kNearlySame) &&
        !shows_before_nearest(item, candidate)) [[unlikely]]
      return;
    nearest = 1 - nearest;
    best = candidate.t;
    ray.t_max = std::min(best * (1 + kNearlySame), limit);
    top = item.object;
    instance = copy;
  }

  [[gnu::noinline]] bool shows_before_nearest(const SearchItem& item, const ShapeHit& candidate) {
    if (item.object == top) return candidate.t < best;
    return set.shows_first(item.object, candidate.t, static_cast<uint32_t>(top), best, ray.origin,
                           ray.direction);
  }

  const ShapeHit& hit() const { return hits[nearest]; }

  bool meets_shape(const SearchItem& item, ShapeHit& candidate) {
    bool met;
    if (item.transform < 0) {
      met = item.shape->closest(ray, stack, candidate);
    } else {
      ShapeRay local = shape_ray(ray, &data.geometry.transforms[item.transform]);
      local.t_max = ray.t_max;
      met = item.shape->closest(local, stack, candidate);
    }
    stack.count_test(item.shape_kind, met);
    candidate.node = item.node;
    return met;
  }

  bool meets_other(const TopLevelObject& object, ShapeHit& candidate, uint32_t& copy) {
    if (object.instance >= 0) {
      const Instance& instanced = data.instances[object.instance];
      const ObjectSet& inner_set = data.groups[instanced.group]->set;
      const SearchList& inner_list =
          &list == set.clear.get() ? inner_set.clear_casters() : inner_set.all;
      GeometryRay inner_ray = local_ray(instanced, ray);
      ClosestSearch inner(data, inner_set, inner_list, inner_ray, stack, ray.t_max);
      inner.least = least;
      inner.run();
      if (inner.top < 0) return false;
      candidate = inner.hit();
      copy = static_cast<uint32_t>(object.instance + 1);
      return true;
    }
    if (object.is_cut_off && !meets_box(object, ray)) return false;
    const GeometryNode& node = data.geometry.nodes[object.node];
    if (node.bounds.count && !data.geometry.passes_bounds(node, ray, stack)) return false;
    return data.geometry.closest(object.node, ray, ray.t_max, stack, candidate);
  }
};

// Whether any opaque object lies on a shadow ray's way, before its t_max.
struct OcclusionSearch {
  const WorldData& data;
  const ObjectSet& set;
  const GeometryRay& ray;
  HitStack& stack;
  const ShadowStart* start;  // null: nothing up to kShadowTolerance counts
  bool blocked = false;
  bool met_nearby = false;  // something that would count otherwise
  uint32_t blocker = HitStack::kNoOccluder;  // position in the list's finite ones

  // The object that stopped the ray before is asked first.
  bool run_with_hint(uint32_t& last) {
    const SearchList& list = set.opaque_casters();
    if (last < list.finite.size() && blocks(list.finite[last])) return true;
    run();
    last = blocker;
    return blocked;
  }

  bool run() {
    const SearchList& list = set.opaque_casters();
    for (const SearchItem& item : list.infinite) {
      if (blocks(item)) return blocked = true;
    }
    if (list.is_scanned) {
      for (const SearchItem& item : list.finite) {
        if (!blocks(item)) continue;
        blocker = static_cast<uint32_t>(&item - list.finite.data());
        return blocked = true;
      }
      return false;
    }
    list.bvh.visit_ray<true>(ray, ray.t_max, [this, &list](uint32_t first, uint32_t count, double&) {
      for (uint32_t i = first; i < first + count; ++i) {
        if (!blocks(list.finite[i])) continue;
        blocker = i;
        return blocked = true;
      }
      return false;
    });
    return blocked;
  }

  // Most items are lone shapes, and most of them are missed.
  [[gnu::always_inline]] bool blocks(const SearchItem& item) {
    if (!item.shape) [[unlikely]] return other_blocks(item);
    ShapeHit hit;
    const bool met = item.transform < 0
                         ? item.shape->closest(ray, stack, hit)
                         : closest_moved(*item.shape, data.geometry.transforms[item.transform], hit);
    stack.count_test(item.shape_kind, met);
    return met && (hit.t > kShadowTolerance || blocks_beyond(item)) &&
           !slips_along_box(set.objects[item.object], ray);
  }

  // Of what is met up to the tolerance.
  [[gnu::noinline]] bool blocks_beyond(const SearchItem& item) {
    ShapeHit hit;
    return find_beyond(data.geometry, item.node, ray, kShadowTolerance, stack, hit) ||
           counts_nearby(item);
  }

  // POV-Ray asks what stopped the light last before all others, and from 1e-4 on. That is taken to be
  // the object itself, or what stops the light beside this point.
  bool counts_nearby(const SearchItem& item) {
    if (set.objects[item.object].instance < 0 && !may_be_remembered(data.geometry.nodes[item.node])) {
      return false;
    }
    met_nearby = true;
    if (!start) return false;
    if (item.object == start->object) return true;
    constexpr double kBeside = 0.003;  // some pixels
    const Vec3& n = start->normal;
    const Vec3 u = unit_or_zero(cross(n, std::abs(n.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
    const Vec3 v = cross(n, u);
    for (const Vec3& side : {u, -u, v, -v}) {
      GeometryRay moved(ray.origin + kBeside * start->distance * side, ray.direction, kShadowRay);
      moved.t_max = ray.t_max;
      OcclusionSearch beside{data, set, moved, stack, nullptr};
      if (beside.blocks(item)) return true;
    }
    return false;
  }

  // POV-Ray has only such in mind whose own texture says at once that it is opaque: one that chooses among
  // others, by a map or by uv, does not, nor do the textures of a CSG's members (measured on povray 3.7).
  bool may_be_remembered(const GeometryNode& node) const {
    if (node.kind == NodeKind::union_) return true;
    const uint32_t texture = data.objects[node.object].texture;
    if (texture == kNoTexture) return node.kind == NodeKind::shape;
    return data.textures[texture].selector == nullptr;
  }

  [[gnu::noinline]] bool other_blocks(const SearchItem& item) {
    const TopLevelObject& object = set.objects[item.object];
    if (object.instance >= 0) {
      const Instance& copy = data.instances[object.instance];
      GeometryRay inner_ray = local_ray(copy, ray);
      inner_ray.t_max = ray.t_max;
      OcclusionSearch inner{data, data.groups[copy.group]->set, inner_ray, stack, nullptr};
      return inner.run() || (inner.met_nearby && counts_nearby(item));
    }
    const GeometryNode& node = data.geometry.nodes[item.node];
    if (object.is_cut_off && item.node == object.node && !casts_whole_shadow(object, node) &&
        !meets_box(object, ray)) {
      return false;
    }
    if (node.bounds.count && !data.geometry.passes_bounds(node, ray, stack)) return false;
    ShapeHit hit;
    if (!data.geometry.closest(item.node, ray, ray.t_max, stack, hit)) return false;
    if (hit.t <= kShadowTolerance && !blocks_beyond(item)) return false;
    // Members of unions are asked by themselves (docs/decisions/0062-shadows-of-bound-unions.md).
    return item.node != object.node || node.kind == NodeKind::union_ ||
           !slips_along_box(object, ray);
  }

  [[gnu::noinline]] bool closest_moved(const Shape& shape, const Transform& transform,
                                       ShapeHit& hit) {
    ShapeRay local = shape_ray(ray, &transform);
    local.t_max = ray.t_max;
    return shape.closest(local, stack, hit);
  }
};

}  // namespace durer
