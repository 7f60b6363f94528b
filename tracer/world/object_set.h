// The objects that a ray looks through at one level, made ready for it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "tracer/intersect/geometry.h"
#include "tracer/world/test_order.h"

namespace durer {

// A top-level object after splitting.
struct TopLevelObject {
  uint32_t node = 0;
  FloatBox box;
  uint8_t hidden = 0;       // RayKind bits
  int32_t instance = -1;    // in WorldData::instances; then `node` means nothing
  bool asks_box = false;    // its own box is asked before it (geometry.md 2.2)
  bool is_cut_off = false;  // what lies outside of the box is not seen
  uint8_t hidden_in_hierarchy = 0;  // likewise, where there is a hierarchy
};

// An object as the walks meet it.
struct SearchItem {
  const Shape* shape = nullptr;  // of a lone shape, without clips and bounds; null: ask the node
  int32_t transform = -1;        // of that shape, in Geometry::transforms
  uint32_t object = 0;           // position in ObjectSet::objects
  uint32_t node = 0;             // in Geometry::nodes; of copies without meaning
  uint8_t hidden = 0;            // RayKind bits
  uint8_t shape_kind = 0;        // of that shape, for statistics: ShapeNode::index()
};

// Some of the objects of a set, made ready for rays.
struct SearchList {
  std::vector<SearchItem> infinite;  // by declaration
  std::vector<SearchItem> finite;    // in the order of the hierarchy's leaves
  Bvh bvh;
  bool is_scanned = false;  // few and simple: asked one after the other, without the hierarchy

  bool is_empty() const { return infinite.empty() && finite.empty(); }
};

// What a ray looks through at one level: the scene, or a shared object.
struct ObjectSet {
  std::vector<TopLevelObject> objects;
  SearchList all;
  // Those that cast shadows, once textures are known: opaque ones, and others. Copies of shared
  // objects may be in both. Null: `all`.
  std::unique_ptr<SearchList> opaque, clear;
  bool uses_bounding = true;
  // For coincident surfaces, and for a start in several objects; made when it is asked for.
  mutable std::once_flag order_made;
  mutable std::unique_ptr<const TestOrder> order;

  // Which of two objects a ray shows that meets both at nearly the same depth (geometry.md 2.3).
  bool shows_first(uint32_t a, double depth_a, uint32_t b, double depth_b, const Vec3& origin,
                   const Vec3& direction) const;
  // Objects as POV-Ray finds them that a point is in.
  void put_in_order_of_hierarchy(std::span<uint32_t> some) const;
  const SearchList& opaque_casters() const { return opaque ? *opaque : all; }
  const SearchList& clear_casters() const { return clear ? *clear : all; }

 private:
  const TestOrder& test_order() const;
};

// After the last object: how their boxes are asked, and what rays of all kinds look through.
void finish_set(const Geometry& geometry, ObjectSet& set, bool uses_bounding);

// What stands for itself among the casters of shadows: an object, or what is part of it, whole,
// whatever bounds it.
struct LooseMember {
  uint32_t object;  // position in ObjectSet::objects
  uint32_t node;
  bool is_bound = false;  // the object as its bounds cut it
};

// Lists the objects of a set that `wanted` says yes to, and members of others.
void fill_search_list(const Geometry& geometry, const ObjectSet& set,
                      const std::function<bool(uint32_t)>& wanted,
                      const std::vector<LooseMember>& members, SearchList& list);

}  // namespace durer
