// The image{} part of image_map, bump_map, image_pattern, material_map and height_field
// (spec/textures.md 12), as written.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tracer/math/vector.h"
#include "tracer/scene/source_position.h"

namespace durer {

class Image;  // tracer/image/image.h: pixels, read once and shared
struct FunctionNode;

enum class ImageMapType { planar = 0, spherical = 1, cylindrical = 2, toroidal = 5 };
enum class ImageInterpolation { none = 0, bilinear = 2, bicubic = 3, normalized_distance = 4 };

struct ImageSource {
  std::shared_ptr<const Image> image;  // loaded by the parser: errors name the line
  ImageMapType map_type = ImageMapType::planar;
  ImageInterpolation interpolation = ImageInterpolation::none;
  bool once = false;
  Vec2 repeat{1, 1};
  Vec2 offset{0, 0};
  bool use_alpha = false;
  bool use_color = false;
  bool use_index = false;
  // `filter all`, `transmit all`; by palette index in order of the text (index, value).
  std::optional<float> filter_all, transmit_all;
  std::vector<std::pair<int, float>> filter_by_index, transmit_by_index;
};

}  // namespace durer
