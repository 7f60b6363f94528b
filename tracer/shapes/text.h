// text {}: one solid per character (spec/geometry.md 12.13).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tracer/shapes/shape.h"

namespace durer {

struct PlacedGlyph {
  std::shared_ptr<const Shape> shape;  // of no area, as of a space, perhaps
  Vec3 offset;
};

// The characters in order; 1 em = 1. Throws std::runtime_error if the font cannot be read.
std::vector<PlacedGlyph> lay_out_text(const TextNode& node);

// Throws if it cannot be read.
void check_font(const std::string& path);

// The statement turns its union by this before any modifier.
inline constexpr double kTextRotationDegrees = 0.001;

}  // namespace durer
