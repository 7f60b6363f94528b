// Rows for the formats of linear light: OpenEXR and Radiance (spec/shading.md 6.2, 6.3).
#pragma once

#include "tracer/image/quantize.h"

namespace durer {

// The pixels in linear light; alpha, if the format has it, goes with premultiplied colours.
class LinearRows {
 public:
  LinearRows(const PixelFormat& format, int width);
  void convert(const PixelColor* pixels, float* out) const;

 private:
  const PixelFormat format_;
  const int width_;
  const OutputTransfer decode_;
};

// RGB in linear light, brought to values that a byte per channel and a common exponent hold exactly.
class RgbeRows {
 public:
  RgbeRows(const PixelFormat& format, int width);
  // Rows must be given from the top.
  void quantize_row(int y, const PixelColor* pixels, float* out);

 private:
  const int width_;
  const OutputTransfer decode_;
  Dithering dithering_;
};

}  // namespace durer
