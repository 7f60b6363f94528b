// Scene -> flat arrays: inheritance, union splitting, lights (spec/geometry.md 2.4, 5).
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "tracer/intersect/geometry.h"
#include "tracer/world/resolved_object.h"
#include "tracer/world/texture_table.h"
#include "tracer/world/world.h"

namespace durer {

// A top-level object after splitting.
struct TopLevelObject {
  uint32_t node = 0;
  FloatBox box;
  uint8_t hidden = 0;       // RayKind bits
  int32_t instance = -1;    // in WorldData::instances; then `node` means nothing
  bool is_cut_off = false;  // what lies outside of the box is not seen (geometry.md 2.2)
};

// What a ray looks through at one level: the scene, or a shared object.
struct ObjectSet {
  std::vector<TopLevelObject> objects;
  std::vector<uint32_t> infinite;  // positions in `objects`, by declaration
  std::vector<uint32_t> finite;
  Bvh bvh;                      // over `finite`
  std::vector<uint8_t> opaque;  // by position, once textures are known
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

// What a node looks like beyond WorldObject.
struct NodeAppearance {
  int32_t own_textures = -1;  // in World arrays: index of the first of a shape's own textures
  int32_t cutaway_root = -1;  // node whose members lend their textures
  bool needs_uv = false;
};

struct WorldData {
  Geometry geometry;
  ObjectSet scene;
  std::vector<std::unique_ptr<SharedGroup>> groups;
  std::vector<Instance> instances;
  std::vector<WorldObject> objects;
  std::vector<NodeAppearance> appearance;  // by node
  std::vector<uint32_t> own_texture_ids;
  std::vector<WorldInterior> interiors;
  std::vector<WorldLight> lights;
  std::vector<LightGroup> light_groups;
  std::vector<int64_t> projected;  // node of each light's projected_through, -1: none
  TextureTable textures;
};

class WorldBuilder {
 public:
  WorldBuilder(WorldData& data, const WorldOptions& options, double atmosphere_ior,
               TexturePtr default_texture);

  void add_top_level(ResolvedObject&& object);
  // Without splitting and materials: for questions of the language and projected_through.
  uint32_t add_bare(const ResolvedObject& object);
  // Boxes and hierarchy, after the last object.
  void finish();
  // Objects at scene level as written, lights among them, decide whether bounding is used.
  void resolve_projected(ObjectResolver& resolver);

 private:
  void split(ResolvedObject&& object, int light_group);
  void inherit(ResolvedObject& object, const ResolvedObject* parent, int parent_interior,
               int& interior);
  uint32_t emit(ResolvedObject& object, const ResolvedObject* parent, int parent_interior,
                int light_group, int32_t filter);
  uint32_t emit_bare(const ResolvedObject& object, bool csg_child);
  NodeRange emit_list(const std::vector<ResolvedObject>& list);
  uint32_t new_node();
  void fill_shape(uint32_t index, const ResolvedObject& object, bool csg_child);
  uint32_t object_number(const WorldObject& object, const ResolvedObject& source);
  void add_instance(const ResolvedObject& copy);
  uint32_t group_of(const std::shared_ptr<const ResolvedObject>& original);
  void finish_set(ObjectSet& set, bool uses_bounding);

  WorldData& data_;
  WorldOptions options_;
  double atmosphere_ior_;
  TexturePtr default_texture_;
  std::unordered_map<const Shape*, uint32_t> owned_;
  std::unordered_map<const ResolvedObject*, uint32_t> groups_;
  std::vector<std::shared_ptr<const ResolvedObject>> originals_;
  ObjectSet* set_;                // that top-level objects go to
  SharedGroup* group_ = nullptr;  // while its members are emitted
};

}  // namespace durer
