#include "tracer/image/quantize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace durer {
namespace {

constexpr int kMostChannels = 4;
using Channels = std::array<float, kMostChannels>;

// Offsets in quantisation steps by place (Bayer).
float bayer_offset(DitherMethod method, int x, int y) {
  static constexpr float k2[2][2] = {{1, 3}, {4, 2}};
  static constexpr float k3[3][3] = {{3, 7, 4}, {6, 1, 9}, {2, 8, 5}};
  static constexpr float k4[4][4] = {{1, 9, 3, 11}, {13, 5, 15, 7}, {4, 12, 2, 10}, {16, 8, 14, 6}};
  switch (method) {
    case DitherMethod::bayer2:
      return k2[x % 2][y % 2] / 4 - 0.5f;
    case DitherMethod::bayer3:
      return k3[x % 3][y % 3] / 9 - 0.5f;
    case DitherMethod::bayer4:
      return k4[x % 4][y % 4] / 16 - 0.5f;
    default:
      return 0;
  }
}

// Error diffusion: what earlier pixels lost is added to later ones.
class ErrorDiffusion {
 public:
  ErrorDiffusion(DitherMethod method, int width)
      : method_(method), row_(width + 2), next_(width + 2) {}

  Channels error_at(int x) const {
    return method_ == DitherMethod::diffusion1 ? carried_ : row_[x + 1];
  }
  void spread(int x, const Channels& error) {
    if (method_ == DitherMethod::diffusion1) {
      carried_ = error;
      return;
    }
    if (x == 0) {
      std::swap(row_, next_);
      std::fill(next_.begin(), next_.end(), Channels{});
    }
    for (int c = 0; c < kMostChannels; ++c) {
      if (method_ == DitherMethod::diffusion2) {
        row_[x + 2][c] += error[c] / 2;
        next_[x + 1][c] += error[c] / 4;
        next_[x + 2][c] += error[c] / 4;
      } else {
        row_[x + 2][c] += error[c] * 7 / 16;
        next_[x][c] += error[c] * 3 / 16;
        next_[x + 1][c] += error[c] * 5 / 16;
        next_[x + 2][c] += error[c] / 16;
      }
    }
  }

 private:
  DitherMethod method_;
  Channels carried_{};
  std::vector<Channels> row_, next_;
};

// A file without premultiplication: colour divided by an alpha that highlights may raise.
void unpremultiply(RGB& color, float& alpha) {
  const float brightness = color.grey();
  if (brightness > alpha) alpha = std::min(1.0f, brightness);
  color *= 1 / (alpha == 0 ? 1e-6f : alpha);
}

}  // namespace

std::vector<uint16_t> quantize(const Framebuffer& picture, const PixelFormat& format) {
  const int channels = format.channels();
  const int colors = format.greyscale ? 1 : 3;
  const float most = static_cast<float>((1 << format.bits) - 1);
  const OutputTransfer transfer(format.working, format.file);
  const bool diffuse = format.dither == DitherMethod::diffusion1 ||
                       format.dither == DitherMethod::diffusion2 ||
                       format.dither == DitherMethod::floyd_steinberg;
  ErrorDiffusion diffusion(format.dither, picture.width());

  std::vector<uint16_t> out;
  out.reserve(static_cast<size_t>(picture.width()) * picture.height() * channels);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const PixelColor& pixel = picture.at(x, y);
      RGB color = pixel.color;
      float alpha = 1 - pixel.transmit;
      if (format.alpha && !format.premultiplied) unpremultiply(color, alpha);
      Channels linear{color.red, color.green, color.blue, alpha};
      if (format.greyscale) linear = {color.grey(), alpha, 0, 0};

      const float offset = bayer_offset(format.dither, x, y) / most;
      Channels error{};
      if (diffuse) error = diffusion.error_at(x);
      Channels lost{};
      for (int c = 0; c < channels; ++c) {
        const bool is_alpha = c == colors;
        const float value = linear[c] + error[c];
        const float encoded = is_alpha ? value : transfer(value);
        // The comparison sends NaN to 0.
        float clipped = encoded + offset;
        clipped = clipped > 0 ? std::min(clipped, 1.0f) : 0.0f;
        const uint16_t code = static_cast<uint16_t>(std::floor(clipped * most + 0.5f));
        out.push_back(code);
        if (diffuse) {
          const float written = static_cast<float>(code) / most;
          const float back =
              is_alpha ? written : OutputTransfer(format.file, format.working)(written);
          lost[c] = std::clamp(value, 0.0f, 1.0f) - back;
        }
      }
      if (diffuse) diffusion.spread(x, lost);
    }
  }
  return out;
}

}  // namespace durer
