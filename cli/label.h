// Text drawn into a picture, by the shapes of text{}.
#pragma once

#include <string>

#include "tracer/image/framebuffer.h"

namespace durer {

class LabelFont {
 public:
  // An installed font without serifs. Throws std::runtime_error if the machine has no fonts.
  LabelFont();

  // ASCII, from `left` to the right on a baseline; `size`: pixels of 1 em. Clipped to the picture.
  void draw(const std::string& text, double left, double baseline, double size, const RGB& color,
            Framebuffer& picture) const;

 private:
  std::string path_;
};

}  // namespace durer
