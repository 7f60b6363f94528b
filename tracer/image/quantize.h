// From linear pixels to a file's numbers: transfer curve, alpha, grey, dithering
// (spec/shading.md 6.3-6.5).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/image/framebuffer.h"
#include "tracer/image/transfer.h"

namespace durer {

enum class DitherMethod { none, bayer2, bayer3, bayer4, diffusion1, diffusion2, floyd_steinberg };

struct PixelFormat {
  TransferCurve working;  // of the scene (assumed_gamma); sRGB where gamma handling is off
  TransferCurve file = TransferCurve::srgb();
  int bits = 8;  // per channel, 5..16
  bool alpha = false;
  bool greyscale = false;
  bool premultiplied = false;  // of the file; PNG, TGA, BMP: no
  DitherMethod dither = DitherMethod::none;

  int channels() const { return (greyscale ? 1 : 3) + (alpha ? 1 : 0); }
};

inline constexpr int kMostChannels = 4;
using Channels = std::array<float, kMostChannels>;

// What quantisation adds to a pixel: an offset by place (Bayer), or what earlier pixels lost (error
// diffusion). Pixels must be asked for and answered in reading order.
class Dithering {
 public:
  Dithering(DitherMethod method, int width);

  bool diffuses() const { return diffuses_; }
  // In quantisation steps.
  float offset(int x, int y) const;
  // Linear light, per channel.
  Channels error_at(int x) const;
  void spread(int x, const Channels& lost);

 private:
  DitherMethod method_;
  bool diffuses_;
  Channels carried_{};
  std::vector<Channels> row_, next_;
};

// round(curve(v) * most) for values clipped to 0..1. For few codes the curve is not evaluated for each
// value: the least v of each code is found once.
class CodeTable {
 public:
  CodeTable(const OutputTransfer& transfer, int most);
  uint16_t operator()(float value) const;
  // Red, green, blue of each pixel.
  void encode_colors(const PixelColor* pixels, int count, uint16_t* out) const;

 private:
  uint16_t code_by_curve(float value) const;

  OutputTransfer transfer_;
  float most_;
  std::vector<float> least_;      // by code; of code 0: -infinity; NaN last. Empty: too many codes
  std::vector<uint16_t> first_;   // by the leading bits of a value: the code to look from
};

// Turns rows of pixels into integers 0 .. 2^bits - 1, channels interleaved.
class Quantizer {
 public:
  Quantizer(const PixelFormat& format, int width);
  // Errors are diffused to the row that is asked for next.
  void quantize_row(int y, const PixelColor* pixels, uint16_t* out);

 private:
  const PixelFormat format_;
  const int width_;
  const float most_;
  const OutputTransfer encode_, decode_;
  CodeTable codes_;
  Dithering dithering_;
};

}  // namespace durer
