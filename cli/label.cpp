#include "cli/label.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "parser/font_replacement.h"
#include "tracer/shapes/text.h"

namespace durer {
namespace {

constexpr int kSubpixels = 4;  // per axis

// The share of a pixel that the glyph covers; x, y: its upper left corner, in em, y up.
float coverage(const Shape& glyph, double x, double y, double pixel) {
  int inside = 0;
  for (int j = 0; j < kSubpixels; ++j) {
    for (int i = 0; i < kSubpixels; ++i) {
      const double u = (i + 0.5) / kSubpixels, v = (j + 0.5) / kSubpixels;
      inside += glyph.inside({x + u * pixel, y - v * pixel, 0.5});
    }
  }
  return static_cast<float>(inside) / (kSubpixels * kSubpixels);
}

}  // namespace

LabelFont::LabelFont() : path_(replacement_font("DejaVuSans.ttf")) {
  if (path_.empty()) throw std::runtime_error("no font is installed to label the picture with");
}

void LabelFont::draw(const std::string& text, double left, double baseline, double size,
                     const RGB& color, Framebuffer& picture) const {
  TextNode node;
  node.font = path_;
  node.text.assign(text.begin(), text.end());
  const double pixel = 1 / size;  // in em
  for (const PlacedGlyph& glyph : lay_out_text(node)) {
    const Bounds box = glyph.shape->bounds();
    const double x0 = left + glyph.offset.x * size, y0 = baseline - glyph.offset.y * size;
    const int first_x = std::max(0, static_cast<int>(std::floor(x0 + box.min.x * size)));
    const int last_x =
        std::min(picture.width() - 1, static_cast<int>(std::ceil(x0 + box.max.x * size)));
    const int first_y = std::max(0, static_cast<int>(std::floor(y0 - box.max.y * size)));
    const int last_y =
        std::min(picture.height() - 1, static_cast<int>(std::ceil(y0 - box.min.y * size)));
    for (int y = first_y; y <= last_y; ++y) {
      for (int x = first_x; x <= last_x; ++x) {
        const float share = coverage(*glyph.shape, (x - x0) * pixel, (y0 - y) * pixel, pixel);
        PixelColor& there = picture.at(x, y);
        there.color = there.color + share * (color - there.color);
      }
    }
  }
}

}  // namespace durer
