// Pigments: a solid colour, or a pattern looked up in a map of colours or pigments
// (spec/textures.md 10, 11).
#include <algorithm>

#include "tracer/scene/not_supported.h"
#include "tracer/texture/blend_map.h"
#include "tracer/texture/default_maps.h"
#include "tracer/texture/image_lookup.h"
#include "tracer/texture/surface_texture.h"
#include "tracer/texture/warp_chain.h"

namespace durer {
namespace {

bool lets_light_through(const ColorRGBFT& c) {
  return std::abs(c.filter) > 1e-10f || std::abs(c.transmit) > 1e-10f;
}

class SolidPigment : public CompiledPigment {
 public:
  explicit SolidPigment(const ColorRGBFT& color) : color_(color) {}
  bool evaluate(const Vec3&, const TextureContext&, ColorRGBFT& color) const override {
    color = color_;
    return true;
  }
  bool is_opaque() const override { return !lets_light_through(color_); }

 private:
  ColorRGBFT color_;
};

class ColorMapPigment : public CompiledPigment {
 public:
  ColorMapPigment(const PigmentNode& node, const PatternSettings& settings)
      : pattern_(node.pattern, settings),
        entries_((node.maps->color_map ? *node.maps->color_map : default_color_map(node.pattern))
                     .entries),
        positions_(entries_) {}

  bool evaluate(const Vec3& point, const TextureContext& context,
                ColorRGBFT& color) const override {
    const MapPlace place = positions_.find(pattern_.value(point, context));
    color = entries_[place.lower].item;
    if (place.lower != place.upper) color = blend(color, entries_[place.upper].item, place.share);
    return true;
  }
  bool is_opaque() const override {
    return std::none_of(entries_.begin(), entries_.end(),
                        [](const auto& entry) { return lets_light_through(entry.item); });
  }

 private:
  Pattern pattern_;
  std::vector<MapEntry<ColorRGBFT>> entries_;
  MapPositions positions_;
};

using PigmentEntry = MapEntry<std::shared_ptr<const CompiledPigment>>;

std::vector<PigmentEntry> compile_entries(const PigmentMap& map, const TextureSettings& settings) {
  std::vector<PigmentEntry> entries;
  for (const auto& entry : map.entries) {
    entries.push_back({entry.position, compile_pigment(*entry.item, settings)});
  }
  return entries;
}

bool all_opaque(const std::vector<PigmentEntry>& entries) {
  return std::all_of(entries.begin(), entries.end(),
                     [](const PigmentEntry& entry) { return entry.item->is_opaque_within(); });
}

class PigmentMapPigment : public CompiledPigment {
 public:
  PigmentMapPigment(const PigmentNode& node, const TextureSettings& settings)
      : pattern_(node.pattern, settings.patterns),
        entries_(compile_entries(*node.maps->pigment_map, settings)),
        positions_(entries_) {}

  bool evaluate(const Vec3& point, const TextureContext& context,
                ColorRGBFT& color) const override {
    const Vec3 warped = pattern_.warp_point(point);
    const MapPlace place = positions_.find(pattern_.value_at_warped(warped, context));
    const bool found = entries_[place.lower].item->evaluate(warped, context, color);
    if (place.lower == place.upper) return found;
    ColorRGBFT upper;
    const bool found_upper = entries_[place.upper].item->evaluate(warped, context, upper);
    color = blend(color, upper, place.share);
    return found || found_upper;
  }
  bool is_opaque() const override { return all_opaque(entries_); }

 private:
  Pattern pattern_;
  std::vector<PigmentEntry> entries_;
  MapPositions positions_;
};

// The weighted mean of its entries.
class AveragePigment : public CompiledPigment {
 public:
  AveragePigment(const PigmentNode& node, const TextureSettings& settings)
      : warps_(chain_with_slot(node.pattern)),
        entries_(compile_entries(*node.maps->pigment_map, settings)) {}

  bool evaluate(const Vec3& point, const TextureContext& context,
                ColorRGBFT& color) const override {
    const Vec3 warped = apply_warps(warps_, point);
    ColorRGBFT sum;
    float weights = 0;
    for (const PigmentEntry& entry : entries_) {
      ColorRGBFT c;
      entry.item->evaluate(warped, context, c);
      sum = sum + c * entry.position;
      weights += entry.position;
    }
    color = {sum.red / weights, sum.green / weights, sum.blue / weights, sum.filter / weights,
             sum.transmit / weights};
    return true;
  }
  bool is_opaque() const override { return all_opaque(entries_); }

 private:
  std::vector<Warp> warps_;
  std::vector<PigmentEntry> entries_;
};

// uv_mapping: the inner pigment lives on the surface's (u, v, 0).
class UvPigment : public CompiledPigment {
 public:
  explicit UvPigment(std::shared_ptr<const CompiledPigment> inner) : inner_(std::move(inner)) {}
  bool evaluate(const Vec3&, const TextureContext& context, ColorRGBFT& color) const override {
    return inner_->evaluate({context.uv.x, context.uv.y, 0}, context, color);
  }
  bool is_opaque() const override { return inner_->is_opaque_within(); }

 private:
  std::shared_ptr<const CompiledPigment> inner_;
};

}  // namespace

std::unique_ptr<const CompiledPigment> compile_pigment(const PigmentNode& node,
                                                       const TextureSettings& settings) {
  if (settings.quality <= 5 && node.quick_color->has_value()) {
    const ColorRGBFT& quick = **node.quick_color;
    if (quick.red != -1 && quick.green != -1 && quick.blue != -1) {
      return std::make_unique<SolidPigment>(quick);
    }
  }
  switch (node.pattern->kind) {
    case PatternKind::none:
      return std::make_unique<SolidPigment>(node.color);
    case PatternKind::uv_mapping:
      if (node.maps->color_map) {  // of a copy: the pattern's value is 0
        return std::make_unique<SolidPigment>(node.maps->color_map->entries.front().item);
      }
      return std::make_unique<UvPigment>(
          compile_pigment(*node.maps->pigment_map->entries.front().item, settings));
    case PatternKind::average:
      return std::make_unique<AveragePigment>(node, settings);
    case PatternKind::image_map:
      return compile_image_pigment(node, settings);
    default:
      if (node.maps->pigment_map) return std::make_unique<PigmentMapPigment>(node, settings);
      return std::make_unique<ColorMapPigment>(node, settings.patterns);
  }
}

}  // namespace durer
