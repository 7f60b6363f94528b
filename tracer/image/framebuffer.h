// The picture while it renders: linear colour in the scene's working space, one value per pixel.
//
// Threads render blocks into Framebuffers of their own and store them in the whole picture, which is
// a Framebuffer too, or a ScratchPicture on the disk where memory is short.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "tracer/scene/color.h"

namespace durer {

// Pixels [left, right) x [top, bottom).
struct PixelWindow {
  int left = 0, top = 0, right = 0, bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
  bool is_empty() const { return left >= right || top >= bottom; }
};

PixelWindow intersection(const PixelWindow& a, const PixelWindow& b);

struct PixelColor {
  RGB color{0.0f};
  float transmit = 0;  // 1: the background shows fully (for alpha output)
};

class Framebuffer;

// A whole picture, filled block by block. Pixels that are never stored are opaque black
// (spec/language.md 32).
class Picture {
 public:
  virtual ~Picture() = default;
  virtual int width() const = 0;
  virtual int height() const = 0;
  // Several threads may store disjoint blocks. Throws std::runtime_error if the disk is full.
  virtual void store(const Framebuffer& block) = 0;
  // Pixels [left, right) of row y. Not while somebody stores them.
  virtual void read(int y, int left, int right, PixelColor* out) const = 0;
};

// A rectangle of pixels in memory.
class Framebuffer : public Picture {
 public:
  Framebuffer(int width, int height) : Framebuffer(PixelWindow{0, 0, width, height}) {}
  explicit Framebuffer(const PixelWindow& window)
      : window_(window),
        pixels_(static_cast<size_t>(window.width()) * static_cast<size_t>(window.height())) {}

  int width() const override { return window_.width(); }
  int height() const override { return window_.height(); }
  const PixelWindow& window() const { return window_; }
  // Coordinates of the whole picture; they must lie in the window.
  PixelColor& at(int x, int y) { return pixels_[index(x, y)]; }
  const PixelColor& at(int x, int y) const { return pixels_[index(x, y)]; }
  PixelColor* pixels() { return pixels_.data(); }
  const PixelColor* pixels() const { return pixels_.data(); }
  size_t bytes() const { return pixels_.size() * sizeof(PixelColor); }

  void store(const Framebuffer& block) override;
  void read(int y, int left, int right, PixelColor* out) const override;

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y - window_.top) * static_cast<size_t>(window_.width()) +
           static_cast<size_t>(x - window_.left);
  }

  PixelWindow window_;
  std::vector<PixelColor> pixels_;
};

// A picture in a file that vanishes with it: holds no pixels in memory.
class ScratchPicture : public Picture {
 public:
  // `folder`: where the file is made, "" for the current one. Throws std::runtime_error.
  ScratchPicture(int width, int height, const std::string& folder);
  ~ScratchPicture() override;
  ScratchPicture(const ScratchPicture&) = delete;
  ScratchPicture& operator=(const ScratchPicture&) = delete;

  int width() const override { return width_; }
  int height() const override { return height_; }
  void store(const Framebuffer& block) override;
  void read(int y, int left, int right, PixelColor* out) const override;

 private:
  int width_, height_;
  int descriptor_;
};

// In memory up to `most_bytes`, beyond that in a scratch file.
std::unique_ptr<Picture> make_picture(int width, int height, size_t most_bytes,
                                      const std::string& folder);

}  // namespace durer
