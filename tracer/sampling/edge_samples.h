// Samples along the edges of finished blocks, for the neighbours that compare with them.
#pragma once

#include <atomic>
#include <vector>

#include "tracer/image/framebuffer.h"

namespace durer {

// A block compares its pixels with one column to its left and one row above it (spec/shading.md 5).
// Where the neighbour has been finished they are here; where it has not, the block traces them
// itself: a sample depends on its place alone, so both give the same bits. Blocks are named by
// their windows. Threads may call all functions at the same time, for different blocks.
class EdgeSamples {
 public:
  using Samples = std::vector<PixelColor>;

  // Blocks of size x size pixels, anchored at the upper left corner of a picture of width x height.
  EdgeSamples(int size, int width, int height);
  ~EdgeSamples();

  // A finished block's right edge, from top to bottom, and lower edge, from left to right.
  void give(const PixelWindow& block, Samples right_edge, Samples lower_edge);
  // The right edge of the block to the left; the lower edge of the block above. Empty where there
  // is none, or none yet. Each can be taken once: only one block asks for it.
  Samples take_left_of(const PixelWindow& block);
  Samples take_above(const PixelWindow& block);

 private:
  struct Edges {
    std::atomic<Samples*> right{nullptr}, lower{nullptr};
  };

  Edges& edges_at(int left, int top) {
    return edges_[static_cast<size_t>(top / size_) * columns_ + static_cast<size_t>(left / size_)];
  }

  int size_, width_, height_;
  size_t columns_;
  std::vector<Edges> edges_;
};

}  // namespace durer
