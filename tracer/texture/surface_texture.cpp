#include "tracer/texture/surface_texture.h"

#include <algorithm>
#include <cmath>

#include "tracer/texture/blend_map.h"
#include "tracer/texture/image_lookup.h"
#include "tracer/texture/warp_chain.h"

namespace durer {
namespace {

using TextureEntry = MapEntry<std::shared_ptr<const CompiledTexture>>;

std::vector<TextureEntry> compile_entries(const TextureMap& map, const TextureSettings& settings) {
  std::vector<TextureEntry> entries;
  for (const auto& entry : map.entries) {
    entries.push_back({entry.position, std::make_shared<const CompiledTexture>(
                                           compile_texture(*entry.item, settings))});
  }
  return entries;
}

class MapSelector : public TextureSelector {
 public:
  MapSelector(const TextureNode& node, std::vector<TextureEntry> entries,
              const TextureSettings& settings)
      : TextureSelector(node),
        pattern_(node.choice->pattern, settings.patterns),
        entries_(std::move(entries)),
        positions_(entries_) {}

  int select(const Vec3& point, const TextureContext& context, Vec3& child_point,
             WeightedTexture out[kMostTextures]) const override {
    child_point = pattern_.warp_point(point);
    const MapPlace place = positions_.find(pattern_.value_at_warped(child_point, context));
    // The upper entry is shaded first: what it encloses still counts for the lower one (14.6).
    int count = 0;
    if (place.lower != place.upper) {
      out[count++] = {entries_[place.upper].item.get(), place.share};
    }
    out[count] = {entries_[place.lower].item.get(), 1 - place.share};
    return count + 1;
  }

 private:
  Pattern pattern_;
  std::vector<TextureEntry> entries_;
  MapPositions positions_;
};

class AverageSelector : public TextureSelector {
 public:
  AverageSelector(const TextureNode& node, std::vector<TextureEntry> entries)
      : TextureSelector(node),
        warps_(chain_with_slot(node.choice->pattern)),
        entries_(std::move(entries)) {
    for (const TextureEntry& entry : entries_) weights_ += entry.position;
  }
  int select(const Vec3& point, const TextureContext&, Vec3& child_point,
             WeightedTexture out[kMostTextures]) const override {
    child_point = apply_warps(warps_, point);
    int count = 0;
    for (const TextureEntry& entry : entries_) {
      out[count++] = {entry.item.get(), entry.position / weights_};
    }
    return count;
  }

 private:
  std::vector<Warp> warps_;
  std::vector<TextureEntry> entries_;
  float weights_ = 0;
};

class UvSelector : public TextureSelector {
 public:
  UvSelector(const TextureNode& node, std::shared_ptr<const CompiledTexture> inner)
      : TextureSelector(node), inner_(std::move(inner)) {}
  int select(const Vec3&, const TextureContext& context, Vec3& child_point,
             WeightedTexture out[kMostTextures]) const override {
    child_point = {context.uv.x, context.uv.y, 0};
    out[0] = {inner_.get(), 1};
    return 1;
  }

 private:
  std::shared_ptr<const CompiledTexture> inner_;
};

void compile_layer(const TextureNode& node, const TextureSettings& settings, TextureLayer& layer) {
  static const PigmentNode black;
  layer.pigment = compile_pigment(node.pigment ? *node.pigment : black, settings);
  if (node.normal && node.normal->pattern->kind != PatternKind::none && settings.quality >= 8) {
    layer.normal = compile_normal(*node.normal, settings);
    layer.normal_keeps_length = node.normal->no_bump_scale;
  }
  static const auto default_finish = std::make_shared<const FinishNode>();
  layer.finish = node.finish ? node.finish : default_finish;
  const FinishNode& finish = *layer.finish;
  layer.is_mirror = !finish.reflection_max.is_black() || !finish.reflection_min.is_black();
  layer.is_lit = finish.diffuse != 0 || finish.diffuse_back != 0 || finish.specular != 0 ||
                 finish.phong != 0;
  layer.is_lit_when_clear = finish.phong > 0 || finish.specular > 0 || finish.crand > 0;
  layer.highlight_exponent = finish.roughness != 0 ? 1 / finish.roughness : 0;
  const auto dark_cosine = [](float strength, float exponent) {
    if (!(strength > 0 && exponent > 0)) return 0.0f;
    return std::pow(1e-12f / std::max(strength, 1.0f), 1 / exponent);
  };
  layer.dark_phong_cosine = dark_cosine(finish.phong, finish.phong_size);
  layer.dark_specular_cosine = dark_cosine(finish.specular, layer.highlight_exponent);
}

}  // namespace

Vec3 layer_normal(const TextureLayer& layer, const EnclosingFrames& enclosing, const Vec3& point,
                  const Vec3& smooth, TextureContext& context) {
  if (!layer.normal) return smooth;
  context.normal = layer.normal->perturb(point, context, enclosing.inwards(smooth));
  return enclosing.outwards(layer.normal_keeps_length ? normalize_or_zero(context.normal)
                                                      : context.normal);
}

CompiledTexture compile_texture(const TextureNode& node, const TextureSettings& settings) {
  CompiledTexture texture;
  switch (node.kind) {
    case TextureNode::Kind::plain:
      // From the top layer down.
      for (const TextureNode* layer = &node; layer; layer = layer->below.get()) {
        compile_layer(*layer, settings, texture.layers.emplace_back());
      }
      texture.is_opaque =
          std::any_of(texture.layers.begin(), texture.layers.end(),
                      [](const TextureLayer& layer) { return layer.pigment->is_opaque(); });
      break;
    case TextureNode::Kind::patterned: {
      std::vector<TextureEntry> entries = compile_entries(*node.choice->map, settings);
      texture.is_opaque = std::all_of(entries.begin(), entries.end(), [](const TextureEntry& e) {
        return e.item->is_opaque;
      });
      if (node.choice->pattern.kind == PatternKind::average) {
        texture.selector = std::make_unique<AverageSelector>(node, std::move(entries));
      } else if (node.choice->pattern.kind == PatternKind::uv_mapping) {
        texture.selector = std::make_unique<UvSelector>(node, entries.front().item);
      } else {
        texture.selector = std::make_unique<MapSelector>(node, std::move(entries), settings);
      }
      break;
    }
    case TextureNode::Kind::material_map: {
      std::vector<std::shared_ptr<const CompiledTexture>> materials;
      for (const auto& material : node.choice->materials) {
        materials.push_back(
            std::make_shared<const CompiledTexture>(compile_texture(*material, settings)));
        texture.is_opaque = texture.is_opaque && materials.back()->is_opaque;
      }
      texture.selector = make_material_selector(node, std::move(materials), settings);
      break;
    }
  }
  return texture;
}

}  // namespace durer
