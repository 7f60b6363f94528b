// Focal blur: a picture's sample is the mean of rays through many points of the lens, as many as
// its spread asks for (spec/shading.md 4).
#pragma once

#include <vector>

#include "tracer/image/framebuffer.h"
#include "tracer/sampling/jitter.h"
#include "tracer/sampling/lens.h"
#include "tracer/scene/camera.h"
#include "tracer/texture/surface_texture.h"

namespace durer {

class FocalBlur {
 public:
  // `textures` is used here only: it compiles the bokeh.
  FocalBlur(const CameraNode& camera, const TextureSettings& textures);

  // The mean of trace(x, y, lens point in radii of the aperture, number of the sample), integers at
  // pixel centres.
  template <typename Trace>
  PixelColor sample(double x, double y, const Trace& trace) const {
    const int seed = static_cast<int>(313 * x + 11) + static_cast<int>(311 * y + 17);
    Sum sum;
    size_t batch = 0;
    const int most = static_cast<int>(lens_.points.size());
    do {
      const int end = batch_ends_[batch++];
      for (int n = sum.count; n < end; ++n) {
        const Vec2 offset = offset_in_pixel(seed + n);
        const double sx = x + offset.x, sy = y + offset.y;
        const Vec2 jitter = sample_jitter(sx + 0.5, sy - 0.5);
        const Vec2 lens = lens_.points[n] + 2 * lens_.jitter * jitter;
        sum.add(trace(sx, sy, lens, n));
      }
    } while (sum.count < most &&
             !(sum.count >= least_samples_ && sum.spread_below(thresholds_[batch - 1])));
    return sum.mean();
  }

 private:
  // Sums of the samples and of their squares.
  struct Sum {
    int count = 0;
    double value[4] = {}, square[4] = {};  // red, green, blue, transmit

    void add(const PixelColor& c);
    bool spread_below(double threshold) const;
    PixelColor mean() const;
  };

  static Vec2 offset_in_pixel(int seed);

  LensPattern lens_;
  int least_samples_;
  std::vector<int> batch_ends_;     // the number of samples after each batch
  std::vector<double> thresholds_;  // the variance of the mean that is small enough then
};

}  // namespace durer
