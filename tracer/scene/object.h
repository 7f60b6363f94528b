// An object value: a shared shape, or another object, plus what this statement did to it
// (design.md rule 6). Copying a handle and `object{Tree translate v}` are O(1).
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "tracer/scene/node_memory.h"
#include "tracer/scene/rare.h"
#include "tracer/scene/shapes.h"

namespace durer {

enum class ObjectFlag : uint8_t {
  hollow, double_illuminate, no_image, no_reflection, no_radiosity, no_shadow, sturm, hierarchy,
  split_union, cutaway_textures, uv_mapping, inverse, global_lights,
};

struct PhotonSettings {  // photons{} of an object (spec/gi.md A1.2)
  std::optional<double> target;  // spacing multiplier
  std::optional<bool> refraction, reflection, pass_through, collect;
  bool operator==(const PhotonSettings&) const = default;
};

// The parser has resolved `pigment{}`, `normal{}`, `finish{}` and layering into whole textures.
struct SetTexture { TexturePtr texture; };
// What surfaces without a texture of their own get in the end, from this object at scene level on;
// its last modifier. Does not count as a texture of the object (inheritance goes first, spec/geometry.md 5).
struct SetDefaultTexture { TexturePtr texture; };
struct SetInteriorTexture { TexturePtr texture; };
struct SetInterior { std::shared_ptr<const InteriorNode> interior; };
struct SetFlag { ObjectFlag flag; bool value; };  // inverse: toggles
struct AddBounds { Rare<std::vector<ObjectPtr>> objects; };
struct AddClips { Rare<std::vector<ObjectPtr>> objects; };
struct ShareBoundsAsClips {};  // clipped_by{bounded_by}
struct ShareClipsAsBounds {};  // bounded_by{clipped_by}
struct SetPhotons { Rare<PhotonSettings> photons; };
struct SetRadiosityImportance { double importance; };

// In the order of the text. A transform acts on what is there at that point.
using Modifier = std::variant<Rare<Transform>, SetTexture, SetDefaultTexture, SetInteriorTexture,
                              SetInterior, SetFlag,
                              AddBounds, AddClips, ShareBoundsAsClips, ShareClipsAsBounds,
                              SetPhotons, SetRadiosityImportance>;

struct ObjectNode {
  ObjectNode() = default;
  ObjectNode(const ObjectNode&) = default;
  ObjectNode& operator=(const ObjectNode&) = default;
  // Takes a chain of copies of copies apart without recursion.
  ~ObjectNode();

  // Exactly one of these: the statement's own shape, or the object that it copies.
  std::shared_ptr<const ShapeNode> shape;
  ObjectPtr base;
  std::vector<Modifier, NodeAllocator<Modifier>> modifiers;
  SourcePosition position;
  // Shapes that it stands for once its copies are written out, with those of its clips and bounds;
  // levels of CSG below this object, and of copies of copies: the parser bounds them all.
  float parts = 1;
  uint16_t csg_depth = 0, copy_depth = 0;
};

// The textures that an object handle has after its modifiers (what `pigment{}` in a copy starts
// from, spec/language.md 25).
struct ResolvedTextures {
  TexturePtr texture;
  TexturePtr interior_texture;
  std::shared_ptr<const InteriorNode> interior;
  bool uv_mapping = false;
};
ResolvedTextures resolve_textures(const ObjectNode& object,
                                  PlainColors plain = PlainColors::stay);
// The shape at the end of the chain of copies.
const ShapeNode& shape_of(const ObjectNode& object);

}  // namespace durer
