// Textures compiled for shading: what a surface looks like at a point (spec/textures.md 10-15).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/patterns/pattern.h"
#include "tracer/scene/texture.h"
#include "tracer/texture/normal_frame.h"

namespace durer {

// What a texture may ask of the surface besides the point.
using TextureContext = PatternContext;

// What the compilation of textures needs to know of the scene.
struct TextureSettings {
  PatternSettings patterns;
  int quality = 9;
  int effective_version = 370;
  bool no_bump_scale = false;  // handed down by an enclosing normal
};

class CompiledPigment {
 public:
  virtual ~CompiledPigment() = default;
  // False when the pigment has no colour here (outside a `once` image): then color is <1,1,1,0,1>.
  virtual bool evaluate(const Vec3& point, const TextureContext& context,
                        ColorRGBFT& color) const = 0;
  // True if no point of it can have filter or transmit.
  virtual bool is_opaque() const = 0;
  // What a pigment takes it for that is made of this one: see ImagePigment.
  virtual bool is_opaque_within() const { return is_opaque(); }
};

class CompiledNormal {
 public:
  virtual ~CompiledNormal() = default;
  // The perturbed normal: a unit vector, except with no_bump_scale (slope sees it so; shading
  // normalises it).
  virtual Vec3 perturb(const Vec3& point, const TextureContext& context,
                       const Vec3& normal) const = 0;
};

struct TextureLayer {
  std::unique_ptr<const CompiledPigment> pigment;
  std::unique_ptr<const CompiledNormal> normal;  // null: none
  std::shared_ptr<const FinishNode> finish;      // never null
  bool normal_keeps_length = false;              // no_bump_scale: perturb() gives any length
  float highlight_exponent = 20;  // 1/roughness
  // Cosines up to which highlights are darker than 1e-12: not worth a power.
  float dark_phong_cosine = 0;
  float dark_specular_cosine = 0;
  bool is_mirror = false;         // the finish reflects rays
  bool is_lit = true;             // the finish answers to lights
  bool is_lit_when_clear = true;  // also where the pigment lets all light through
};

struct CompiledTexture;

// A texture and its share of the surface.
struct WeightedTexture {
  const CompiledTexture* texture;
  double weight;
};

// Chooses among textures by place: texture_map, tiles, average, material_map, uv_mapping.
class TextureSelector {
 public:
  static constexpr int kMostTextures = 256;  // entries of a map (spec/textures.md 10)

  explicit TextureSelector(const TextureNode& node)
      : frame(node.choice->pattern.warps, node.no_bump_scale) {}
  virtual ~TextureSelector() = default;
  // Writes the textures to blend (weights sum to 1) and the point at which they are looked up.
  virtual int select(const Vec3& point, const TextureContext& context, Vec3& child_point,
                     WeightedTexture out[kMostTextures]) const = 0;

  const NormalFrame frame;
};

// Plain: layers from the top down. Else: a selector over further textures.
struct CompiledTexture {
  std::vector<TextureLayer> layers;
  std::unique_ptr<const TextureSelector> selector;
  bool is_opaque = true;
};

// The normal of a layer for shading; not of length 1 under a patterned texture with no_bump_scale.
// `smooth` is the normal of the shape, facing the ray. context.normal is what the layer's normal pattern
// sees on entry (bent, if another layer was shaded before), and what its pigment sees on return: bent, but
// still in the space of the enclosing textures.
Vec3 layer_normal(const TextureLayer& layer, const EnclosingFrames& enclosing, const Vec3& point,
                  const Vec3& smooth, TextureContext& context);

CompiledTexture compile_texture(const TextureNode& texture, const TextureSettings& settings);
std::unique_ptr<const CompiledPigment> compile_pigment(const PigmentNode& pigment,
                                                       const TextureSettings& settings);
std::unique_ptr<const CompiledNormal> compile_normal(const NormalNode& normal,
                                                     const TextureSettings& settings);

}  // namespace durer
