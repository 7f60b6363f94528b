// image_pattern: the grey, or the alpha, of a picture.
//
//   png "file" | gif "file" | …   the picture
//   use_alpha                     1 - alpha where it has one, else red
//
//   pigment { image_pattern { png "mask.png" interpolate 2 once } color_map { ... } }
//
// Source: spec/textures.md 12.5.
#include <algorithm>

#include "tracer/image/image.h"
#include "tracer/patterns/pattern_factories.h"
#include "tracer/patterns/pattern_grey.h"

namespace durer {
namespace {

// TIFF, OpenEXR and Radiance are kept as RGBA, alpha in the file or not; palettes of TIFF and BMP have
// none.
bool has_alpha_to_povray(const Image& image) {
  if (image.type() == ImageFileType::tiff) return !image.is_palette();
  if (image.type() == ImageFileType::bmp) return image.has_alpha();
  return image.has_alpha() || image.is_palette() || image.type() == ImageFileType::exr ||
         image.type() == ImageFileType::hdr;
}

class ImagePattern : public BasePattern {
 public:
  ImagePattern(std::shared_ptr<const Image> image, const ImageSource& source)
      : sampler_(std::move(image), source), use_alpha_(source.use_alpha) {
    has_alpha_ = has_alpha_to_povray(sampler_.image());
  }
  double base_value(const Vec3& p, const PatternContext&) const override {
    double x, y;
    if (!sampler_.locate(p, x, y)) return 0;
    const ColorRGBFT c = sampler_.color(x, y);
    // Bicubic interpolation swings beyond 0 and 1.
    const float value = !use_alpha_ ? pattern_grey(c) : has_alpha_ ? c.transmit : c.red;
    return std::clamp(static_cast<double>(value), 0.0, 1.0);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  ImageSampler sampler_;
  bool use_alpha_, has_alpha_;
};

}  // namespace

std::unique_ptr<const BasePattern> make_image_pattern(const PatternNode& node,
                                                      const PatternSettings& settings) {
  return std::make_unique<ImagePattern>(settings.images->get(*node.image, ImageUse::raw),
                                        *node.image);
}

}  // namespace durer
