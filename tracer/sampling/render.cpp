#include "tracer/sampling/render.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tracer/sampling/antialiasing.h"
#include "tracer/system/thread_limit.h"

namespace durer {
namespace {

// Blocks are anchored at pixel (0,0) of the whole picture, in rows (design.md rule 4d).
std::vector<PixelWindow> blocks_of(const RenderOptions& options, int size) {
  std::vector<PixelWindow> blocks;
  for (int top = 0; top < options.height; top += size) {
    for (int left = 0; left < options.width; left += size) {
      const PixelWindow block{left, top, std::min(left + size, options.width),
                              std::min(top + size, options.height)};
      if (!intersection(block, options.window).is_empty()) blocks.push_back(block);
    }
  }
  return blocks;
}

// What is not a number is black, as in the pictures of POV-Ray; infinite light stays.
void blacken_nan(Framebuffer& framebuffer) {
  const size_t count = framebuffer.bytes() / sizeof(PixelColor);
  for (size_t i = 0; i < count; ++i) {
    PixelColor& pixel = framebuffer.pixels()[i];
    for (float* value : {&pixel.color.red, &pixel.color.green, &pixel.color.blue, &pixel.transmit}) {
      if (std::isnan(*value)) *value = 0;
    }
  }
}

void add(ShapeTestCounts& sum, const ShapeTestCounts& part) {
  for (size_t i = 0; i < sum.size(); ++i) {
    for (int met = 0; met < 2; ++met) sum[i].by_outcome[met] += part[i].by_outcome[met];
  }
}

void add(RenderStatistics& sum, const RenderStatistics& part) {
  sum.samples += part.samples;
  add(sum.shapes, part.shapes);
  sum.rays.primary += part.rays.primary;
  sum.rays.reflected += part.rays.reflected;
  sum.rays.refracted += part.rays.refracted;
  sum.rays.shadow += part.rays.shadow;
  sum.rays.total_internal += part.rays.total_internal;
}

// oneTBB orders what is done before, in and after the blocks. ThreadSanitizer does not see that in a
// library that was not built for it: it must not look at what oneTBB's tasks carry, which is read here
// and nowhere else, and the two counts in render() say the order once more. They order no block before
// another, so races between blocks are found even if they did not meet.
template <typename Function>
struct BlockTask {
  const Function& render_blocks;

  [[gnu::no_sanitize("thread")]] void operator()(const tbb::blocked_range<size_t>& range) const {
    render_blocks(range.begin(), range.end());
  }
};

}  // namespace

RenderStatistics render(const ShadingScene& scene, const Camera& camera,
                        const Integrator& integrator, const RenderOptions& options,
                        Picture& picture, RenderObserver& observer,
                        const std::atomic<bool>& stop) {
  const PixelSampler sampler(scene, camera, integrator, options.width, options.height);
  const SampleContrast contrast(scene.scene, options);
  const int block_size = std::min(options.block_size, std::max(options.width, options.height));
  std::vector<PixelWindow> blocks = blocks_of(options, block_size);
  std::erase_if(blocks, [&](const PixelWindow& block) {
    return !observer.block_wanted(intersection(block, options.window));
  });

  const bool compares = options.supersampling == Supersampling::method1 ||
                        options.supersampling == Supersampling::method2;
  EdgeSamples edges(block_size, compares ? options.width : 0, compares ? options.height : 0);
  auto render_block = [&](const PixelWindow& block, RenderStatistics& statistics) {
    if (stop.load(std::memory_order_relaxed)) return;
    Framebuffer framebuffer(intersection(block, options.window));
    switch (options.supersampling) {
      case Supersampling::none:
        render_block_without_antialiasing(sampler, block, options.window, framebuffer,
                                          statistics);
        break;
      case Supersampling::method1:
        render_block_method1(sampler, contrast, options, block, options.window, edges, framebuffer,
                             statistics);
        break;
      case Supersampling::method2:
        render_block_method2(sampler, contrast, options, block, options.window, edges, framebuffer,
                             statistics);
        break;
      case Supersampling::grid:
      case Supersampling::jitter:
        render_block_grid(sampler, options, options.supersampling == Supersampling::jitter, block,
                          options.window, framebuffer, statistics);
        break;
    }
    blacken_nan(framebuffer);
    add(statistics.shapes, take_shape_tests());
    picture.store(framebuffer);
    observer.block_done(framebuffer);
  };

  RenderStatistics total;
  if (options.threads <= 1 || blocks.size() == 1) {
    // No threads are started for what one can do.
    for (const PixelWindow& block : blocks) render_block(block, total);
    return total;
  }
  enforce_thread_limit();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<size_t>(options.threads));
  tbb::task_arena arena(options.threads);
  tbb::enumerable_thread_specific<RenderStatistics> statistics;
  std::atomic<size_t> begun, ended;
  begun.store(0, std::memory_order_release);
  const auto render_blocks = [&](size_t begin, size_t end) {
    static_cast<void>(begun.load(std::memory_order_acquire));
    for (size_t i = begin; i != end; ++i) render_block(blocks[i], statistics.local());
    ended.fetch_add(1, std::memory_order_release);
  };
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, blocks.size(), 1),
                      BlockTask<decltype(render_blocks)>{render_blocks},
                      tbb::simple_partitioner());
  });
  static_cast<void>(ended.load(std::memory_order_acquire));
  for (const RenderStatistics& part : statistics) add(total, part);
  return total;
}

}  // namespace durer
