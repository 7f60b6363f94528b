// What happens when a block is finished: progress, the state file, the preview.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>

#include "cli/progress.h"
#include "cli/state_file.h"
#include "tracer/sampling/render.h"

namespace durer {

class RenderWatch : public RenderObserver {
 public:
  // state: null if nothing is kept. Pixels outside the window are not counted.
  RenderWatch(Progress& progress, StateFile* state, const PixelWindow& window)
      : progress_(progress), state_(state), window_(window) {}

  // Calls `write` with a copy of the finished blocks every `seconds`.
  void preview(const Framebuffer& picture, double seconds,
               std::function<void(const Framebuffer&)> write);

  bool block_wanted(const PixelWindow& block) override;
  void block_done(const PixelWindow& block) override;

 private:
  struct Preview {
    const Framebuffer& picture;
    Framebuffer finished;  // a copy, so that nobody reads pixels that are being written
    std::chrono::duration<double> interval;
    std::chrono::steady_clock::time_point last;
    std::function<void(const Framebuffer&)> write;
  };
  int64_t pixels_in_window(const PixelWindow& block) const;
  void update_preview(const PixelWindow& block);

  Progress& progress_;
  StateFile* state_;
  const PixelWindow window_;
  std::optional<Preview> preview_;
  std::mutex preview_mutex_;
};

}  // namespace durer
