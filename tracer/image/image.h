// Pictures as textures use them: decoded pixels, and how a point of space finds its pixel
// (spec/textures.md 12).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "tracer/image/raster_file.h"
#include "tracer/math/vector.h"
#include "tracer/scene/color.h"
#include "tracer/scene/scene.h"

namespace durer {

// What the pixels mean: colours of image_map are brought to the scene's working space, all other
// uses take the file's numbers (spec/textures.md 12.7).
enum class ImageUse : uint8_t { color, raw };

struct WorkingSpace {
  int effective_version = 370;
  AssumedGamma kind = AssumedGamma::none;
  double gamma = 1;
};

class Image {
 public:
  Image(std::shared_ptr<const RasterFile> file, const ImageSource& source, ImageUse use,
        const WorkingSpace& space);

  int width() const { return file_->width; }
  int height() const { return file_->height; }
  bool is_palette() const { return file_->is_palette(); }
  bool has_alpha() const { return file_->has_alpha(); }
  bool is_opaque() const { return opaque_; }
  int palette_size() const { return static_cast<int>(file_->palette.size()); }
  ImageFileType type() const { return file_->type; }
  const RasterFile& raster() const { return *file_; }

  // x, y must lie inside. Alpha a gives transmit 1 - a.
  ColorRGBFT pixel(int x, int y) const;
  int index(int x, int y) const { return file_->bytes[at(x, y)]; }

 private:
  size_t at(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(file_->width) + static_cast<size_t>(x);
  }
  float value(size_t position, bool alpha) const;
  void decode_grey_of_png();

  std::shared_ptr<const RasterFile> file_;
  std::vector<float> decode_;  // of 8- and 16-bit values
  std::vector<float> floats_;  // decoded; empty: as in the file
  std::vector<ColorRGBFT> palette_;
  bool opaque_ = true;
};

// Each file is decoded once per scene and use.
class ImageCache {
 public:
  explicit ImageCache(const WorkingSpace& space) : space_(space) {}
  std::shared_ptr<const Image> get(const ImageSource& source, ImageUse use);

 private:
  using Key = std::tuple<std::string, int, int, int, double>;
  WorkingSpace space_;
  std::map<Key, std::shared_ptr<const Image>> images_;
};

// An image with the options of its statement.
class ImageSampler {
 public:
  ImageSampler(std::shared_ptr<const Image> image, const ImageSource& source);

  // Pixel coordinates of a point; false outside (spec/textures.md 12.2).
  bool locate(const Vec3& point, double& x, double& y) const;
  // Interpolated colour there, with the statement's filter and transmit; not un-premultiplied.
  ColorRGBFT color(double x, double y) const;
  // The palette index, interpolated like a colour, then cut to an integer.
  int index(double x, double y) const;
  const Image& image() const { return *image_; }
  bool is_opaque() const;
  // Without the `filter all` and `transmit all` of an image that has no palette.
  bool is_opaque_before_additions() const;
  bool is_premultiplied() const { return premultiplied_; }

 private:
  template <typename Value, typename Fetch>
  Value interpolate(double x, double y, Fetch&& fetch) const;
  ColorRGBFT fetch(int x, int y) const;

  std::shared_ptr<const Image> image_;
  ImageMapType map_type_;
  ImageInterpolation interpolation_;
  bool once_, premultiplied_;
  double width_, height_;                  // pixels
  double repeated_width_, repeated_height_;
  Vec2 offset_;
  float added_filter_ = 0, added_transmit_ = 0;
  std::vector<ColorRGBFT> palette_;  // with the statement's filter and transmit
};

}  // namespace durer
