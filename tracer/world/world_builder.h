// Scene -> flat arrays: inheritance, union splitting, lights (spec/geometry.md 2.4, 5).
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include "tracer/intersect/geometry.h"
#include "tracer/system/pages_ahead.h"
#include "tracer/world/resolved_object.h"
#include "tracer/world/test_order.h"
#include "tracer/world/texture_table.h"
#include "tracer/world/world.h"

namespace durer {

// A top-level object after splitting.
struct TopLevelObject {
  uint32_t node = 0;
  FloatBox box;
  uint8_t hidden = 0;       // RayKind bits
  int32_t instance = -1;    // in WorldData::instances; then `node` means nothing
  bool asks_box = false;    // its own box is asked before it (geometry.md 2.2)
  bool is_cut_off = false;  // what lies outside of the box is not seen
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

// A declared object that many copies share, in its own space.
struct SharedGroup {
  ObjectSet set;
  uint32_t first_object = 0, object_count = 0;            // its WorldObjects
  std::vector<MovedTexture> textures, interior_textures;  // of these, before the copy's move
};
struct Instance {
  uint32_t group;
  Transform transform;
  uint32_t first_object;  // its own WorldObjects, in the group's order
};

// The ray in the copy's own space, with the same parameters.
inline GeometryRay local_ray(const Instance& instance, const GeometryRay& ray) {
  return {instance.transform.inverse_point(ray.origin),
          instance.transform.inverse_direction(ray.direction), ray.kind, false};
}

// See World::has_remembered_casters().
struct RememberedCaster {
  uint32_t node;     // in Geometry::nodes
  int32_t instance;  // -1: not in a copy
};

// What a node looks like beyond WorldObject.
struct NodeAppearance {
  int32_t own_textures = -1;  // in World arrays: index of the first of a shape's own textures
  int32_t cutaway_root = -1;  // node whose members lend their textures
  bool needs_uv = false;
  bool has_unit_normals = false;  // of the shape, which has no transform
};

struct WorldData {
  Geometry geometry;
  ObjectSet scene;
  std::vector<std::unique_ptr<SharedGroup>> groups;
  std::vector<Instance> instances;
  std::vector<WorldObject> objects;
  std::vector<NodeAppearance> appearance;  // by node
  std::vector<uint32_t> own_texture_ids;
  InteriorTable interiors;
  std::vector<IndirectSettings> indirect{IndirectSettings{}};
  std::vector<WorldLight> lights;
  std::vector<RememberedCaster> remembered;
  std::vector<LightGroup> light_groups;
  std::vector<int64_t> projected;  // node of each light's projected_through, -1: none
  std::vector<CompiledTexture> textures;
};

// Where rays look for an object. Empty: never met; unbounded: met everywhere.
Bounds search_box(const Geometry& geometry, const ObjectSet& set, const TopLevelObject& top);

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

class WorldBuilder {
 public:
  WorldBuilder(WorldData& data, const WorldOptions& options, TexturePtr default_texture,
               const TextureSettings& textures);

  // Makes room for as many objects at scene level.
  void expect(size_t objects);
  void add_top_level(ResolvedObject&& object);
  // Without splitting and materials: for questions of the language and projected_through.
  uint32_t add_bare(const ResolvedObject& object);
  // Boxes and hierarchy, after the last object.
  void finish();
  // Objects at scene level as written, lights among them, decide whether bounding is used.
  void resolve_projected(ObjectResolver& resolver);

 private:
  int add_light_group(const ResolvedObject& group, int parent);
  void split(ResolvedObject&& object, int light_group);
  void inherit(ResolvedObject& object, const ResolvedObject* parent, int parent_interior,
               int& interior);
  uint32_t emit(ResolvedObject& object, const ResolvedObject* parent, int parent_interior,
                int light_group, int32_t filter);
  uint32_t emit_bare(const ResolvedObject& object, bool csg_child);
  NodeRange emit_list(const std::vector<ResolvedObject>& list);
  uint32_t new_node();
  void fill_shape(uint32_t index, const ResolvedObject& object, bool csg_child);
  void finish_node(uint32_t index, const ResolvedObject& object,
                   const std::vector<uint32_t>& children, const NodeRange& clips,
                   const NodeRange& bounds);
  uint32_t indirect_number(const ResolvedObject& object);
  uint32_t object_number(const WorldObject& object, const ResolvedObject& source);
  void add_instance(const ResolvedObject& copy);
  uint32_t group_of(const std::shared_ptr<const ResolvedObject>& original);
  void finish_set(ObjectSet& set, bool uses_bounding);

  WorldData& data_;
  WorldOptions options_;
  TexturePtr default_texture_;
  TextureTable textures_;
  std::unordered_map<const ResolvedObject*, uint32_t> groups_;
  std::vector<std::shared_ptr<const ResolvedObject>> originals_;
  ObjectSet* set_;                // that top-level objects go to
  SharedGroup* group_ = nullptr;  // while its members are emitted
  PagesAhead node_pages_, appearance_pages_, object_pages_, top_level_pages_;
};

}  // namespace durer
