// Scene -> flat arrays: inheritance, union splitting, lights (spec/geometry.md 2.4, 5).
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "tracer/intersect/geometry.h"
#include "tracer/system/pages_ahead.h"
#include "tracer/world/object_set.h"
#include "tracer/world/resolved_object.h"
#include "tracer/world/texture_table.h"
#include "tracer/world/world.h"

namespace durer {

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
