#include "tracer/sampling/edge_samples.h"

namespace durer {
namespace {

size_t count_of(int extent, int size) {
  return static_cast<size_t>((extent + size - 1) / size);
}

}  // namespace

EdgeSamples::EdgeSamples(int size, int width, int height)
    : size_(size),
      columns_(count_of(width, size)),
      stride_(static_cast<size_t>(size) + 1),
      samples_(2 * columns_ * count_of(height, size) * stride_),
      finished_(columns_ * count_of(height, size)) {}

const PixelColor* EdgeSamples::left_of(const PixelWindow& block) const {
  if (block.left == 0) return nullptr;
  const size_t neighbour = index(block) - 1;
  if (!finished_[neighbour].load(std::memory_order_acquire)) return nullptr;
  return &samples_[2 * neighbour * stride_];
}

const PixelColor* EdgeSamples::above(const PixelWindow& block) const {
  if (block.top == 0) return nullptr;
  const size_t neighbour = index(block) - columns_;
  if (!finished_[neighbour].load(std::memory_order_acquire)) return nullptr;
  return &samples_[(2 * neighbour + 1) * stride_];
}

void EdgeSamples::publish(const PixelWindow& block) {
  finished_[index(block)].store(true, std::memory_order_release);
}

}  // namespace durer
