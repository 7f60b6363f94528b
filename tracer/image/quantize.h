// From linear pixels to integers: transfer curve, alpha, grey, dithering (spec/shading.md 6.3-6.5).
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/image/framebuffer.h"
#include "tracer/image/transfer.h"

namespace durer {

enum class DitherMethod { none, bayer2, bayer3, bayer4, diffusion1, diffusion2, floyd_steinberg };

struct PixelFormat {
  TransferCurve working;  // of the scene (assumed_gamma); neutral where gamma handling is off
  TransferCurve file = TransferCurve::srgb();
  int bits = 8;  // per channel, 5..16
  bool alpha = false;
  bool greyscale = false;
  bool premultiplied = false;  // of the file; PNG, TGA, BMP: no
  DitherMethod dither = DitherMethod::none;

  int channels() const { return (greyscale ? 1 : 3) + (alpha ? 1 : 0); }
};

// Rows from the top, pixels from the left, channels interleaved; values 0 .. 2^bits - 1.
std::vector<uint16_t> quantize(const Framebuffer& picture, const PixelFormat& format);

}  // namespace durer
