#include "tracer/sampling/focal_blur.h"

#include <algorithm>

#include "tracer/math/lattice_hash.h"
#include "tracer/sampling/chi_square.h"

namespace durer {

FocalBlur::FocalBlur(const CameraNode& camera, const TextureSettings& textures)
    : least_samples_(camera.min_blur_samples) {
  const int most = camera.blur_samples;
  if (camera.bokeh) {
    const auto pigment = compile_pigment(*camera.bokeh, textures);
    lens_ = shaped_lens(most, [&](const Vec2& p) {
      ColorRGBFT color;
      pigment->evaluate({p.x, p.y, 0}, TextureContext{}, color);
      return static_cast<double>(color.rgb().grey());
    });
  } else {
    lens_ = round_lens(most);
  }

  const double scale =
      most > 1 ? camera.variance / chi_square_upper_quantile(most - 1, camera.confidence) : 0;
  for (int end = 0; end < most;) {
    const size_t batch = batch_ends_.size();
    const int size = batch < lens_.first_batches.size() ? lens_.first_batches[batch] : 4;
    end = std::min(end + size, most);
    batch_ends_.push_back(end);
    thresholds_.push_back(scale * chi_square_upper_quantile(end, camera.confidence));
  }
}

Vec2 FocalBlur::offset_in_pixel(int seed) {
  const int column = kLatticeHash[seed & 0xfff] % 16, row = kLatticeHash[(seed + 1) & 0xfff] % 16;
  const Vec2 offset((2 * column + 1) / 32.0 - 0.5, (2 * row + 1) / 32.0 - 0.5);
  const Vec2 jitter = sample_jitter(offset.x, offset.y);
  return offset + (jitter - Vec2(0.5)) / 16.0;
}

void FocalBlur::Sum::add(const PixelColor& c) {
  const double channel[4] = {c.color.red, c.color.green, c.color.blue, c.transmit};
  for (int i = 0; i < 4; ++i) {
    value[i] += channel[i];
    square[i] += channel[i] * channel[i];
  }
  ++count;
}

bool FocalBlur::Sum::spread_below(double threshold) const {
  const double n = count;
  for (int i = 0; i < 4; ++i) {
    const double mean = value[i] / n;
    if ((square[i] / n - mean * mean) / n >= threshold) return false;
  }
  return true;
}

PixelColor FocalBlur::Sum::mean() const {
  const double share = 1.0 / count;
  return {{(float)(value[0] * share), (float)(value[1] * share), (float)(value[2] * share)},
          (float)(value[3] * share)};
}

}  // namespace durer
