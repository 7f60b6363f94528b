#include "tracer/texture/image_lookup.h"

#include <algorithm>

#include "tracer/image/image.h"
#include "tracer/texture/warp_chain.h"

namespace durer {
namespace {

class ImagePigment final : public CompiledPigment {
 public:
  ImagePigment(const PigmentNode& node, const TextureSettings& settings)
      : warps_(chain_with_slot(node.pattern)),
        sampler_(settings.patterns.images->get(*node.pattern->image, ImageUse::color),
                 *node.pattern->image) {}

  bool evaluate(const Vec3& point, const TextureContext&, ColorRGBFT& color) const override {
    double x, y;
    if (!sampler_.locate(apply_warps(warps_, point), x, y)) {
      color = {1, 1, 1, 0, 1};
      return false;
    }
    color = sampler_.color(x, y);
    if (sampler_.is_premultiplied() && 1 - color.transmit > 1e-10f)
      color.set_rgb(color.rgb() * (1 / (1 - color.transmit)));
    return true;
  }
  bool is_opaque() const override { return sampler_.is_opaque(); }
  // Within other pigments POV-Ray forgets what the statement adds: shadows are black.
  bool is_opaque_within() const override { return sampler_.is_opaque_before_additions(); }

 private:
  std::vector<Warp> warps_;
  ImageSampler sampler_;
};

class MaterialSelector final : public TextureSelector {
 public:
  MaterialSelector(const TextureNode& node,
                   std::vector<std::shared_ptr<const CompiledTexture>> materials,
                   const TextureSettings& settings)
      : TextureSelector(node),
        warps_(chain_with_slot(node.choice->pattern)),
        sampler_(settings.patterns.images->get(*node.choice->pattern.image, ImageUse::raw),
                 *node.choice->pattern.image),
        materials_(std::move(materials)) {}

  int select(const Vec3& point, const TextureContext&, Vec3& child_point,
             WeightedTexture out[kMostTextures]) const override {
    child_point = apply_warps(warps_, point);
    double x, y;
    int number = 0;
    if (sampler_.locate(child_point, x, y)) {
      number = sampler_.index(x, y);
      // Texture 0 where the index of an image without a palette is lost in its interpolation, as
      // povray has it; else the number is in the red of the pixel.
      if (number != 0 && !sampler_.image().is_palette()) {
        number = static_cast<int>(sampler_.color(x, y).red * 255);
      }
    }
    const int count = static_cast<int>(materials_.size());
    if (number > count) number %= count;
    number = std::clamp(number, 0, count - 1);
    out[0] = {materials_[static_cast<size_t>(number)].get(), 1};
    return 1;
  }

 private:
  std::vector<Warp> warps_;
  ImageSampler sampler_;
  std::vector<std::shared_ptr<const CompiledTexture>> materials_;
};

}  // namespace

std::unique_ptr<const CompiledPigment> compile_image_pigment(const PigmentNode& node,
                                                             const TextureSettings& settings) {
  return std::make_unique<ImagePigment>(node, settings);
}

std::unique_ptr<const TextureSelector> make_material_selector(
    const TextureNode& node, std::vector<std::shared_ptr<const CompiledTexture>> materials,
    const TextureSettings& settings) {
  return std::make_unique<MaterialSelector>(node, std::move(materials), settings);
}

}  // namespace durer
