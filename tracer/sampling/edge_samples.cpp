#include "tracer/sampling/edge_samples.h"

#include <memory>
#include <utility>

namespace durer {
namespace {

size_t count_of(int extent, int size) {
  return static_cast<size_t>((extent + size - 1) / size);
}

EdgeSamples::Samples take(std::atomic<EdgeSamples::Samples*>& edge) {
  const std::unique_ptr<EdgeSamples::Samples> samples(
      edge.exchange(nullptr, std::memory_order_acquire));
  return samples ? std::move(*samples) : EdgeSamples::Samples();
}

void put(std::atomic<EdgeSamples::Samples*>& edge, EdgeSamples::Samples&& samples) {
  edge.store(new EdgeSamples::Samples(std::move(samples)), std::memory_order_release);
}

}  // namespace

EdgeSamples::EdgeSamples(int size, int width, int height)
    : size_(size),
      width_(width),
      height_(height),
      columns_(count_of(width, size)),
      edges_(columns_ * count_of(height, size)) {}

EdgeSamples::~EdgeSamples() {
  for (Edges& edges : edges_) {
    take(edges.right);
    take(edges.lower);
  }
}

void EdgeSamples::give(const PixelWindow& block, Samples right_edge, Samples lower_edge) {
  Edges& edges = edges_at(block.left, block.top);
  if (block.right < width_) put(edges.right, std::move(right_edge));
  if (block.bottom < height_) put(edges.lower, std::move(lower_edge));
}

EdgeSamples::Samples EdgeSamples::take_left_of(const PixelWindow& block) {
  return block.left > 0 ? take(edges_at(block.left - 1, block.top).right) : Samples();
}

EdgeSamples::Samples EdgeSamples::take_above(const PixelWindow& block) {
  return block.top > 0 ? take(edges_at(block.left, block.top - 1).lower) : Samples();
}

}  // namespace durer
