// What is found out about a node once, when it is made: where it lies, and how rays go about it.
#include <algorithm>

#include "tracer/intersect/convex_sweep.h"
#include "tracer/intersect/geometry.h"

namespace durer {
namespace {

// Composites with at least this many children get a hierarchy (performance.md 4).
constexpr uint32_t kTreeThreshold = 24;

}  // namespace

void Geometry::finish_node(uint32_t index) {
  GeometryNode& node = nodes[index];
  if (node.kind == NodeKind::merge || node.kind == NodeKind::union_) take_in_own_kind(node);
  enclose(index);
  // A sphere or box in place is met or missed as fast as its bounds; so is an intersection that
  // starts with one.
  const auto is_quick = [](const GeometryNode& n) {
    return n.kind == NodeKind::shape && n.transform < 0 && n.shape->is_quickly_missed();
  };
  node.is_boxed = node.surface_is_bounded && !is_quick(node);
  if (node.kind == NodeKind::shape) {
    const Shape& shape = *node.shape;
    node.narrows = shape.is_convex_solid() && !node.inverted && node.clips.count == 0 &&
                   node.bounds.count == 0;
    node.places_hits = shape.places_hits();
    node.is_half_space = shape.is_half_space();
    node.looks_along_world = node.transform >= 0 && shape.looks_along_world();
    node.holds_outside = shape.is_outside_of_convex();
    return;
  }
  if (node.kind == NodeKind::intersection || node.kind == NodeKind::merge) plan_sweep(index);
  if (node.kind == NodeKind::intersection && node.children.count > 0 && node.tree < 0) {
    const GeometryNode& first = nodes[lists[node.children.first]];
    node.is_boxed &= !(first.narrows && is_quick(first));
  }
}

// Notes the convex solids of a CSG, where it is made of them alone.
void Geometry::plan_sweep(uint32_t index) {
  GeometryNode& node = nodes[index];
  std::vector<uint32_t> solids;
  SweepPlan plan;
  if (!gather_convex_solids(index, -1, solids, plan)) return;
  const bool is_flat =
      std::all_of(plan.parts.begin(), plan.parts.end(),
                  [](const SweptPart& part) { return part.kind == NodeKind::intersection; });
  if (solids.size() > kMostSweptSolids && !is_flat) return;
  if (node.tree >= 0) {
    // What stands in the hierarchy is cut out through it.
    solids.clear();
    for (const uint32_t i : trees[node.tree]->others) {
      solids.push_back(lists[node.children.first + i]);
    }
  }
  node.swept = {static_cast<uint32_t>(lists.size()), static_cast<uint32_t>(solids.size())};
  node.is_flat = is_flat;
  // What is cut out comes last: most rays miss what it is cut out of.
  if (is_flat) {
    std::stable_partition(solids.begin(), solids.end(),
                          [&](uint32_t solid) { return !nodes[solid].inverted; });
  }
  lists.insert(lists.end(), solids.begin(), solids.end());
  if (!is_flat) {
    lists.push_back(static_cast<uint32_t>(sweep_plans.size()));
    sweep_plans.push_back(std::move(plan));
  }
}

// A merge of merges is one of all their members: where those are many, one hierarchy holds them. So
// are unions of unions, but for those that have a hierarchy: it serves as well. Hits come in the
// same order, as a merge passes on its members' hits reversed and a union as they are.
void Geometry::take_in_own_kind(GeometryNode& node) {
  std::vector<uint32_t> all;
  const bool is_merge = node.kind == NodeKind::merge;
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const uint32_t child = lists[node.children.first + i];
    const GeometryNode& member = nodes[child];
    const uint32_t* own = lists.data() + member.children.first;
    const bool is_plain =
        member.kind == node.kind && (is_merge || member.tree < 0) && !member.hidden &&
        member.clips.count == 0 && member.bounds.count == 0 &&
        std::all_of(own, own + member.children.count, [&](uint32_t c) { return !nodes[c].hidden; });
    if (!is_plain) {
      all.push_back(child);
      continue;
    }
    if (is_merge) {
      for (uint32_t k = member.children.count; k-- > 0;) all.push_back(own[k]);
    } else {
      all.insert(all.end(), own, own + member.children.count);
    }
  }
  if (all.size() == node.children.count || (is_merge && all.size() < kTreeThreshold)) return;
  node.children = {static_cast<uint32_t>(lists.size()), static_cast<uint32_t>(all.size())};
  lists.insert(lists.end(), all.begin(), all.end());
}

void Geometry::enclose(uint32_t index) {
  GeometryNode& node = nodes[index];
  node.reach = Bounds::everything();
  if (node.kind == NodeKind::shape) {
    Bounds box = node.shape->bounds();
    if (!box.is_empty() && box.is_bounded() && node.shape->is_solid_within_bounds()) {
      if (node.transform >= 0) box = transforms[node.transform].bounds(box);
      const Vec3 margin = 2e-9 * (glm::abs(box.min) + glm::abs(box.max)) + Vec3(1e-9);
      node.reach = {box.min - margin, box.max + margin};
      node.surface_is_bounded = box.is_bounded();
      node.contains_outside = node.inverted && !node.shape->is_patch();
    }
    // A clipped solid contains nothing outside of its clips.
    if (node.clips.count) node.contains_outside = false;
    if (node.clips.count && node.inverted) node.surface_is_bounded = false;
    return;
  }
  if (node.kind == NodeKind::nothing) return;

  // Bounds of the surface. An intersection lies within each member that is empty outside its own;
  // otherwise the members' surfaces enclose it.
  const uint32_t* child = lists.data() + node.children.first;
  const bool is_intersection = node.kind == NodeKind::intersection;
  Bounds joined, common = Bounds::everything();
  bool all_bounded = true, has_common = false;
  bool outside = is_intersection;
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const GeometryNode& member = nodes[child[i]];
    if (!member.has_object) continue;
    if (!member.surface_is_bounded) {
      all_bounded = false;
      continue;
    }
    joined.extend(member.reach);
    if (member.contains_outside != is_intersection) outside = !is_intersection;
    if (is_intersection && !member.contains_outside) {
      common.clip(member.reach);
      has_common = true;
    }
  }
  if (is_intersection && has_common) {
    node.reach = common;
    node.surface_is_bounded = true;
    node.contains_outside = false;
    if (common.is_empty()) node.kind = NodeKind::nothing;
  } else if (all_bounded && !joined.is_empty()) {
    node.reach = joined;
    node.surface_is_bounded = true;
    node.contains_outside = outside;
  }
  if (node.clips.count) {
    if (node.contains_outside) node.surface_is_bounded = false;
    node.contains_outside = false;
  }

  if (node.children.count < kTreeThreshold) return;
  auto tree = std::make_unique<ChildTree>();
  std::vector<Bounds> boxes;
  std::vector<uint32_t> bounded;
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const GeometryNode& member = nodes[child[i]];
    if (member.kind == NodeKind::nothing && !member.has_object) continue;
    // Members that decide far from their surface are always asked.
    if (member.surface_is_bounded && member.contains_outside == is_intersection &&
        !member.reach.is_empty()) {
      bounded.push_back(i);
      boxes.push_back(member.reach);
    } else {
      tree->others.push_back(i);
    }
  }
  if (boxes.size() < kTreeThreshold) return;
  tree->bvh.build(boxes);
  for (const uint32_t item : tree->bvh.items()) tree->bounded.push_back(bounded[item]);
  node.tree = static_cast<int32_t>(trees.size());
  trees.push_back(std::move(tree));
}

}  // namespace durer
