// Samples along the edges of finished blocks, for the neighbours that compare with them.
#pragma once

#include <atomic>
#include <vector>

#include "tracer/image/framebuffer.h"

namespace durer {

// A block compares its pixels with one column to its left and one row above it (spec/shading.md 5).
// Where the neighbour has been finished they are here; where it has not, the block traces them
// itself: a sample depends on its place alone, so both give the same bits. Blocks are named by
// their windows.
class EdgeSamples {
 public:
  // Blocks of size x size pixels, anchored at the upper left corner of a picture of width x height.
  EdgeSamples(int size, int width, int height);

  // The right edge of the block to the left, from top to bottom; the lower edge of the block above,
  // from left to right. Null where there is none, or none yet.
  const PixelColor* left_of(const PixelWindow& block) const;
  const PixelColor* above(const PixelWindow& block) const;

  // Room for the block's own edges, up to size + 1 samples each; `publish` shows them to the
  // neighbours.
  PixelColor* right_edge(const PixelWindow& block) { return &samples_[2 * index(block) * stride_]; }
  PixelColor* lower_edge(const PixelWindow& block) { return right_edge(block) + stride_; }
  void publish(const PixelWindow& block);

 private:
  size_t index(const PixelWindow& block) const {
    return static_cast<size_t>(block.top / size_) * columns_ +
           static_cast<size_t>(block.left / size_);
  }

  int size_;
  size_t columns_, stride_;
  std::vector<PixelColor> samples_;
  std::vector<std::atomic<bool>> finished_;
};

}  // namespace durer
