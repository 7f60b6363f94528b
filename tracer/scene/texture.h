// Pigments, normals, finishes, textures, interiors and materials as written
// (spec/textures.md 10-15, spec/shading.md 8).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "tracer/scene/color.h"
#include "tracer/scene/pattern.h"
#include "tracer/scene/rare.h"

namespace durer {

struct MediaNode;

// Maps keep the order of the text; positions are single precision, the search is in double
// (spec/textures.md 10). For `average` the position is the weight.
template <typename Item>
struct MapEntry {
  float position = 0;
  Item item;
};
template <typename Item>
struct BlendMap {
  std::vector<MapEntry<Item>> entries;
};

struct PigmentNode;
struct NormalNode;
struct TextureNode;
struct SlopeAt {
  float height = 0;
  float slope = 0;
};

using ColorMap = BlendMap<ColorRGBFT>;
using PigmentMap = BlendMap<std::shared_ptr<const PigmentNode>>;
using NormalMap = BlendMap<std::shared_ptr<const NormalNode>>;
using SlopeMap = BlendMap<SlopeAt>;
using TextureMap = BlendMap<std::shared_ptr<const TextureNode>>;

// What a pattern's values choose among.
struct PigmentMaps {
  std::shared_ptr<const ColorMap> color_map = nullptr;  // null with pigment_map; else the default
  // pigment_map, pigment lists, average; uv_mapping: one entry
  std::shared_ptr<const PigmentMap> pigment_map = nullptr;
};

// A solid colour, or a pattern with a map. Lists (checker a, b) are maps with positions 0, 1, ...
// Also a density{}: then colours are taken as rgb.
struct PigmentNode {
  // kind none: solid `color` (or unspecified, see is_unspecified). kind uv_mapping: the
  // map's first entry is what follows in the braces, looked up at (u,v,0). kind image_map: pattern.image.
  Rare<PatternNode> pattern;
  bool is_unspecified = true;  // neither colour nor pattern was given: black
  ColorRGBFT color;
  Rare<PigmentMaps> maps;
  // quick_color, used at quality <= 5 when no component is -1.
  Rare<std::optional<ColorRGBFT>> quick_color;
};

// normal{}: pattern with a bump size (spec/textures.md 14).
struct NormalNode {
  Rare<PatternNode> pattern;
  float bump_size = 0.5f;
  float accuracy = 0.02f;
  bool no_bump_scale = false;
  std::shared_ptr<const SlopeMap> slope_map;
  std::shared_ptr<const NormalMap> normal_map;  // normal_map, lists, average; uv_mapping: one entry
};

struct Irid {
  float amount = 0;
  float thickness = 0;
  float turbulence = 0;
};

// finish{} (spec/shading.md 8; defaults spec/language.md 20). After parse-time normalisation:
// albedo forms are already converted to the plain factors.
struct FinishNode {
  RGB ambient{0.1f};
  RGB emission{0.0f};
  float diffuse = 0.6f;
  float diffuse_back = 0;
  float brilliance = 1;
  float phong = 0;
  float phong_size = 40;
  float specular = 0;
  float roughness = 0.05f;  // as written; highlight exponent is 1/roughness
  float metallic = 0;
  float crand = 0;
  bool conserve_energy = false;
  RGB reflection_min{0.0f};
  RGB reflection_max{0.0f};
  bool reflection_fresnel = false;
  float reflection_falloff = 1;
  float reflection_exponent = 1;
  float reflection_metallic = 0;
  Irid irid;
  bool has_subsurface = false;
  RGB subsurface_translucency{0.0f};
  RGB subsurface_anisotropy{0.0f};
  // finish{ior caustics refraction} of old scenes; negative: not given.
  float legacy_ior = -1, legacy_caustics = -1, legacy_refraction = -1;
};

// What a texture that is not plain chooses by, and among what.
struct TextureChoice {
  // patterned (also tiles = checker, average, uv_mapping with one entry at position 0)
  PatternNode pattern;
  std::shared_ptr<const TextureMap> map;
  // material_map: pattern.image selects among these
  std::vector<std::shared_ptr<const TextureNode>> materials;
};

// One texture: plain (pigment, normal, finish), patterned (a pattern and a texture_map), or a
// material_map.
struct TextureNode {
  enum class Kind : uint8_t { plain, patterned, material_map };
  Kind kind = Kind::plain;
  bool no_bump_scale = false;
  std::shared_ptr<const PigmentNode> pigment;
  std::shared_ptr<const NormalNode> normal;  // null: none
  std::shared_ptr<const FinishNode> finish;
  Rare<TextureChoice> choice;  // of the other kinds
  // Layered texture: the layer below this one (null for the bottom). A TextureNode pointer thus
  // names a whole stack, whose top is this node.
  std::shared_ptr<const TextureNode> below;
};

using TexturePtr = std::shared_ptr<const TextureNode>;

// A plain colour looks the same wherever it is moved; a pigment{} that is written later and gives
// it a pattern starts with its transforms (decision 0067).
enum class PlainColors : uint8_t { stay, move };

// The same after `transform` (acts on every layer; spec/textures.md 15.2).
std::shared_ptr<const PigmentNode> transformed(const std::shared_ptr<const PigmentNode>& pigment,
                                               const Transform& transform,
                                               PlainColors plain = PlainColors::stay);
std::shared_ptr<const NormalNode> transformed(const std::shared_ptr<const NormalNode>& normal,
                                              const Transform& transform);
TexturePtr transformed(const TexturePtr& texture, const Transform& transform,
                       PlainColors plain = PlainColors::stay);

struct InteriorNode {
  float ior = 0;  // 0: not set
  float dispersion = 1;
  int dispersion_samples = 7;
  float caustics = 0;
  float refraction = 1;  // counts only under a patterned texture, see the finish's
  RGB fade_color{0.0f};
  float fade_distance = 0;
  float fade_power = 0;
  std::vector<std::shared_ptr<const MediaNode>> media;
  SourcePosition position;
};

// The same with the densities of its media moved.
std::shared_ptr<const InteriorNode> transformed(const std::shared_ptr<const InteriorNode>& interior,
                                                const Transform& transform);

struct MaterialNode {
  TexturePtr texture;
  TexturePtr interior_texture;
  std::shared_ptr<const InteriorNode> interior;
};

}  // namespace durer
