// The image{} part of image_map, bump_map, image_pattern, material_map and height_field
// (spec/textures.md 12), as written.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tracer/math/vector.h"
#include "tracer/scene/source_position.h"

namespace durer {

// What an image file holds (tracer/image/raster_file.h).
struct RasterFile;

// A function image, evaluated where it was read: 16 bits per value, grey or RGBA, row 0 on top.
struct FunctionRaster {
  int width = 0, height = 0, channels = 1;
  std::vector<uint16_t> values;
};

enum class ImageMapType { planar = 0, spherical = 1, cylindrical = 2, toroidal = 5 };
enum class ImageInterpolation { none = 0, bilinear = 2, bicubic = 3, normalized_distance = 4 };

enum class ImageFileType { by_name, tga, png, ppm, pgm, gif, iff, jpeg, tiff, bmp, exr, hdr, pot, function };
enum class ImageGamma { automatic, power, srgb };

struct ImageSource {
  // As found. Empty: a function image.
  std::string path;
  // Its pixels, shared by all statements that name the file. Null: a function image.
  std::shared_ptr<const RasterFile> raster;
  ImageFileType type = ImageFileType::by_name;
  ImageGamma gamma_kind = ImageGamma::automatic;
  double gamma = 1;
  std::optional<bool> premultiplied;
  std::shared_ptr<const FunctionRaster> function;  // image_map { function w, h { ... } }
  ImageMapType map_type = ImageMapType::planar;
  ImageInterpolation interpolation = ImageInterpolation::none;
  bool once = false;
  Vec2 repeat{1, 1};
  Vec2 offset{0, 0};
  bool use_alpha = false;
  bool use_color = false;
  bool use_index = false;
  // Palette index or `all`, and value, in order of the text.
  static constexpr int kAllIndices = -1;
  std::vector<std::pair<int, float>> filter, transmit;
  SourcePosition position;
};

}  // namespace durer
