// Supersampling, blocks, threads: the same above every integrator.
#pragma once

#include <atomic>
#include <cstdint>

#include "tracer/cameras/camera.h"
#include "tracer/image/framebuffer.h"
#include "tracer/sampling/render_options.h"
#include "tracer/shading/integrator.h"
#include "tracer/shading/shading_scene.h"

namespace durer {

// Told of finished blocks, from several threads at a time.
class RenderObserver {
 public:
  virtual ~RenderObserver() = default;
  // False: the block is in the picture already (a continued render). Asked before the first block
  // is rendered, from one thread. Blocks are cut at the window's borders.
  virtual bool block_wanted(const PixelWindow&) { return true; }
  // After the block was stored.
  virtual void block_done(const Framebuffer& block) = 0;
};

struct RenderStatistics {
  RayCounts rays;
  uint64_t samples = 0;
  ShapeTestCounts shapes{};
};

// Renders the window into the picture. `stop` is looked at before every block; blocks that were
// begun are finished. Same bits for any number of threads and any window.
RenderStatistics render(const ShadingScene& scene, const Camera& camera,
                        const Integrator& integrator, const RenderOptions& options,
                        Picture& picture, RenderObserver& observer,
                        const std::atomic<bool>& stop);

}  // namespace durer
