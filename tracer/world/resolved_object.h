// An object after its modifiers have been replayed in order: what the world is built from
// (spec/geometry.md 3, 4, 6).
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "tracer/scene/light.h"
#include "tracer/shapes/shape.h"
#include "tracer/intersect/float_box.h"
#include "tracer/world/compiled_shapes.h"

namespace durer {

// A texture and how it has been moved since it was set: move by move, since that is how its patterns
// are moved in POV-Ray, and where they jump the last digits show it.
struct MovedTexture {
  TexturePtr texture;
  std::vector<Transform> moves;
  bool stays = false;  // on the surface, wherever the object goes

  explicit operator bool() const { return texture != nullptr; }
  // Copies of copies may have been moved thousands of times: what comes after so many is one move.
  static constexpr size_t kMostMoves = 32;
  void move(const Transform& by) {
    if (!texture || stays) return;
    if (moves.size() < kMostMoves) {
      moves.push_back(by);
    } else {
      moves.back() = moves.back().then(by);
    }
  }
};

struct ResolvedObject {
  enum class Kind : uint8_t { shape, csg, light, copy };
  Kind kind = Kind::shape;

  // shape
  std::shared_ptr<const Shape> shape;  // null: degenerate, never hit
  uint8_t shape_kind = 0;              // ShapeNode::index()
  const ShapeNode* written = nullptr;  // its statement
  bool is_plane = false, is_quadric = false, is_height_field = false;
  bool has_transform = false;
  Rare<Transform> transform;
  bool inverted = false;

  // csg
  CsgKind csg = CsgKind::union_;
  bool written_as_difference = false, is_light_group = false, global_lights = true;
  std::vector<ResolvedObject> children;

  // light; its only child is looks_like
  std::shared_ptr<const LightNode> light;

  // copy of a declared object that is used many times, only moved (by `transform`)
  std::shared_ptr<const ResolvedObject> original;

  std::vector<ResolvedObject> bounds, clips;
  bool bounds_are_clips = false;  // then `clips` holds the list

  MovedTexture texture, interior_texture;
  TexturePtr default_texture;
  std::shared_ptr<const InteriorNode> interior;
  int shared_interior = -1;  // number given by a union that was split
  bool interior_moved = false;
  Rare<Transform> interior_transform;
  bool uv_mapping = false;
  bool uv_mapping_of_parent = false;  // seen at (u, v) as well, but the texture has moved
  bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false;
  bool hollow = false, hollow_given = false, double_illuminate = false;
  bool cutaway_textures = false, split_union = true;
  bool is_csg_child = false;
  bool is_light_of_group = false;  // a light written directly in a light_group
  PhotonSettings photons;
  double radiosity_importance = -1;

  FloatBox box;
  bool box_from_quadric = false;

  void move(const Transform& transform);
  void invert();
  // Patches have no inside; neither has what holds one.
  bool has_inside() const;
  bool has_texture_anywhere() const;
  void mark_as_csg_child();
  // Turns a copy into the whole object.
  void expand();

 private:
  void recompute_box();
};

// Replays handles; shapes and declared objects that are used many times are compiled once.
class ObjectResolver {
 public:
  ObjectResolver(CompiledShapes& shapes, int effective_version)
      : shapes_(shapes), effective_version_(effective_version) {}

  // Marks the objects that the scene uses often: these stay shared where they are only moved.
  void find_shared(const std::vector<ObjectPtr>& scene);
  ResolvedObject resolve(const ObjectPtr& object);

 private:
  ResolvedObject resolve_base(const ObjectNode& object);
  ResolvedObject resolve_shape(const ObjectNode& object);
  ResolvedObject resolve_primitive(const ObjectNode& object);
  ResolvedObject resolve_light(const std::shared_ptr<const LightNode>& light);
  PlacedShape compiled(const ObjectNode& object);
  ResolvedObject resolve_csg(const CsgNode& node);
  ResolvedObject resolve_text(const std::shared_ptr<const ShapeNode>& node);
  void apply(ResolvedObject& object, const Modifier& modifier, bool is_copy);

  CompiledShapes& shapes_;
  int effective_version_;
  // Originals of copies by node; null until the first use.
  std::unordered_map<ObjectPtr, std::shared_ptr<const ResolvedObject>> shared_;
};

}  // namespace durer
