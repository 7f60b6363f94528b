// What happens when a block is finished: progress, the state file, the preview.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "cli/progress.h"
#include "cli/state_file.h"
#include "tracer/sampling/render.h"

namespace durer {

class RenderWatch : public RenderObserver {
 public:
  // state: null if nothing is kept. `warn` is called from any thread.
  RenderWatch(Progress& progress, StateFile* state, std::function<void(const std::string&)> warn)
      : progress_(progress), state_(state), warn_(std::move(warn)) {}

  // Calls `write` every `seconds` with the finished blocks of the picture; what `write` throws
  // becomes a warning and ends the preview.
  void preview(const Picture& picture, int block_size, double seconds,
               std::function<void(const Picture&)> write);

  bool block_wanted(const PixelWindow& block) override;
  void block_done(const Framebuffer& block) override;

 private:
  class FinishedBlocks;
  struct Preview {
    std::shared_ptr<FinishedBlocks> finished;
    std::chrono::duration<double> interval;
    std::chrono::steady_clock::time_point last;
    std::function<void(const Picture&)> write;
    bool failed = false;
  };
  void update_preview();

  Progress& progress_;
  StateFile* state_;
  std::function<void(const std::string&)> warn_;
  std::optional<Preview> preview_;
  std::mutex preview_mutex_;
};

}  // namespace durer
