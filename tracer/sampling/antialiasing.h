// POV-Ray's antialiasing methods on one block of pixels (spec/shading.md 5).
#pragma once

#include <vector>

#include "tracer/sampling/edge_samples.h"
#include "tracer/sampling/pixel_sampler.h"

namespace durer {

// How different two samples look: the sum of channel differences after the antialias gamma.
class SampleContrast {
 public:
  SampleContrast(const Scene& scene, const RenderOptions& options);
  bool differ(const PixelColor& a, const PixelColor& b) const;

 private:
  // Bounds of an encoded value.
  struct Range {
    float low, high;
  };

  float encode(float value) const;
  Range encoded_range(float value) const;
  bool differ_exactly(const PixelColor& a, const PixelColor& b) const;

  AssumedGamma gamma_kind_;
  float decode_exponent_;  // of the working space; 1: linear
  float encode_exponent_;  // 1/antialias gamma; 1: none
  double threshold_;
  // The curve, which rises, at the values that share their exponent and first bits of the mantissa:
  // most samples are told apart by bounds alone.
  std::vector<float> steps_;
};

// Renders a block into the framebuffer; of pixels outside `window` nothing is written.
void render_block_without_antialiasing(const PixelSampler& sampler, const PixelWindow& block,
                                       const PixelWindow& window, Framebuffer& framebuffer,
                                       RenderStatistics& statistics);
// +AM1: supersample pixels that differ from their left or upper neighbour.
void render_block_method1(const PixelSampler& sampler, const SampleContrast& contrast,
                          const RenderOptions& options, const PixelWindow& block,
                          const PixelWindow& window, EdgeSamples& edges, Framebuffer& framebuffer,
                          RenderStatistics& statistics);
// +AM2: subdivide pixels whose corners differ.
void render_block_method2(const PixelSampler& sampler, const SampleContrast& contrast,
                          const RenderOptions& options, const PixelWindow& block,
                          const PixelWindow& window, EdgeSamples& edges, Framebuffer& framebuffer,
                          RenderStatistics& statistics);
// A regular or jittered grid of n x n samples in every pixel, for teaching.
void render_block_grid(const PixelSampler& sampler, const RenderOptions& options, bool jittered,
                       const PixelWindow& block, const PixelWindow& window,
                       Framebuffer& framebuffer, RenderStatistics& statistics);

}  // namespace durer
