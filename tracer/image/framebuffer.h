// The picture while it renders: linear colour in the scene's working space, one value per pixel.
// Threads write disjoint pixels, so no locks.
#pragma once

#include <cstddef>
#include <vector>

#include "tracer/scene/color.h"

namespace durer {

struct PixelColor {
  RGB color{0.0f};
  float transmit = 0;  // 1: the background shows fully (for alpha output)
};

class Framebuffer {
 public:
  // Pixels that are never rendered stay opaque black (spec/language.md 32).
  Framebuffer(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<size_t>(width) * height) {}

  int width() const { return width_; }
  int height() const { return height_; }
  PixelColor& at(int x, int y) { return pixels_[static_cast<size_t>(y) * width_ + x]; }
  const PixelColor& at(int x, int y) const {
    return pixels_[static_cast<size_t>(y) * width_ + x];
  }

 private:
  int width_, height_;
  std::vector<PixelColor> pixels_;
};

}  // namespace durer
