#include "tracer/world/object_set.h"

#include <algorithm>

#include "tracer/intersect/float_box.h"
#include "tracer/system/pages_ahead.h"

namespace durer {
namespace {

// Up to the rounding of boxes.
bool encloses(const Bounds& box, const Bounds& surface) {
  const Vec3 margin = 1e-6 * (glm::abs(box.min) + glm::abs(box.max)) + Vec3(1e-9);
  return glm::all(glm::lessThanEqual(box.min - margin, surface.min)) &&
         glm::all(glm::greaterThanEqual(box.max + margin, surface.max));
}

bool is_exempt(const GeometryNode& node) {
  return node.kind == NodeKind::shape && node.shape->is_exempt_from_box_test();
}

// Some shapes are, where there is no hierarchy.
bool is_seen_outside_box(const GeometryNode& node, const ObjectSet& set) {
  return !set.uses_bounding && is_exempt(node);
}

// Where rays look for an object. Empty: never met; unbounded: met everywhere.
Bounds search_box(const Geometry& geometry, const ObjectSet& set, const TopLevelObject& top) {
  if (top.instance < 0) {
    const GeometryNode& node = geometry.nodes[top.node];
    if (is_seen_outside_box(node, set)) {
      return node.surface_is_bounded ? node.reach : Bounds::everything();
    }
  }
  return top.box.is_infinite() ? Bounds::everything() : top.box.to_bounds();
}

}  // namespace

const TestOrder& ObjectSet::test_order() const {
  std::call_once(order_made, [&] {
    std::vector<FloatBox> all_boxes;
    for (const TopLevelObject& object : objects) all_boxes.push_back(object.box);
    order = std::make_unique<const TestOrder>(all_boxes);
  });
  return *order;
}

bool ObjectSet::shows_first(uint32_t a, double depth_a, uint32_t b, double depth_b,
                            const Vec3& origin, const Vec3& direction) const {
  const bool is_nearer = depth_a < depth_b;
  if (!uses_bounding) return is_nearer || (depth_a == depth_b && a < b);
  // Where the ray is in the box of the nearer one well before, the walk comes to it: nearly always, so
  // that large worlds need no hierarchy of POV-Ray's for this.
  constexpr double kWellBefore = 1 - 1e-5;
  const double before = kWellBefore * std::min(depth_a, depth_b);
  if (depth_a != depth_b && objects[is_nearer ? a : b].box.contains(origin + before * direction)) {
    return is_nearer;
  }
  return test_order().shows_first(a, depth_a, b, depth_b, origin, direction);
}

void ObjectSet::put_in_order_of_hierarchy(std::span<uint32_t> some) const {
  std::sort(some.begin(), some.end());
  if (!uses_bounding) return;
  const TestOrder& known = test_order();
  std::sort(some.begin(), some.end(),
            [&](uint32_t a, uint32_t b) { return known.rank(a) < known.rank(b); });
}

void finish_set(const Geometry& geometry, ObjectSet& set, bool uses_bounding) {
  set.uses_bounding = uses_bounding;
  for (TopLevelObject& top : set.objects) {
    if (top.instance >= 0) continue;
    if (uses_bounding) top.hidden |= top.hidden_in_hierarchy;
    const GeometryNode& node = geometry.nodes[top.node];
    // What is too large for the hierarchy is tested on its own, too.
    if (top.box.is_infinite() ? is_exempt(node) || !top.box.to_bounds().is_bounded()
                              : is_seen_outside_box(node, set)) {
      continue;
    }
    top.asks_box = !is_exempt(node);
    top.is_cut_off = !node.surface_is_bounded || !encloses(top.box.to_bounds(), node.reach);
  }
  fill_search_list(
      geometry, set, [](uint32_t) { return true; }, {}, set.all);
}

// Up to so many spheres and boxes are asked faster than a hierarchy over them.
constexpr size_t kMostScanned = 3;

void fill_search_list(const Geometry& geometry, const ObjectSet& set,
                      const std::function<bool(uint32_t)>& wanted,
                      const std::vector<LooseMember>& members, SearchList& list) {
  const auto box_of = [&](const LooseMember& part) {
    if (part.is_bound) return search_box(geometry, set, set.objects[part.object]);
    const GeometryNode& node = geometry.nodes[part.node];
    return node.surface_is_bounded ? node.reach : Bounds::everything();
  };
  const auto item_of = [&](const LooseMember& part) {
    const TopLevelObject& top = set.objects[part.object];
    SearchItem item;
    item.object = part.object;
    item.hidden = top.hidden;
    if (top.instance >= 0) return item;
    item.node = part.node;
    const GeometryNode& node = geometry.nodes[part.node];
    if (node.kind == NodeKind::shape && !node.clips.count && !node.bounds.count &&
        !(part.is_bound && top.is_cut_off)) {
      item.shape = node.shape;
      item.transform = node.transform;
      item.shape_kind = node.shape_kind;
    }
    return item;
  };
  std::vector<LooseMember> bounded;  // items are made once their order is known: they are large
  Bounds whole;
  const auto add = [&](const LooseMember& part) {
    const Bounds box = box_of(part);
    if (box.is_empty()) return;
    if (box.is_bounded()) {
      bounded.push_back(part);
      whole.extend(box);
    } else {
      list.infinite.push_back(item_of(part));
    }
  };
  for (uint32_t i = 0; i < set.objects.size(); ++i) {
    if (wanted(i)) add({i, set.objects[i].node, true});
  }
  for (const LooseMember& member : members) add(member);
  list.bvh.build(bounded.size(), whole, [&](uint32_t i) { return box_of(bounded[i]); });
  list.finite.reserve(bounded.size());
  PagesAhead item_pages;
  for (const uint32_t i : list.bvh.items()) {
    item_pages.before_push(list.finite);
    list.finite.push_back(item_of(bounded[i]));
  }
  const auto is_quick = [](const SearchItem& item) {
    return item.shape && item.transform < 0 && item.shape->is_quickly_missed();
  };
  list.is_scanned = list.finite.size() <= kMostScanned &&
                    std::all_of(list.finite.begin(), list.finite.end(), is_quick);
}

}  // namespace durer
