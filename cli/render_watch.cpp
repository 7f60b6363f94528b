#include "cli/render_watch.h"

#include <algorithm>

namespace durer {

int64_t RenderWatch::pixels_in_window(const PixelWindow& block) const {
  const int width = std::min(block.right, window_.right) - std::max(block.left, window_.left);
  const int height = std::min(block.bottom, window_.bottom) - std::max(block.top, window_.top);
  return static_cast<int64_t>(std::max(width, 0)) * std::max(height, 0);
}

void RenderWatch::preview(const Framebuffer& picture, double seconds,
                          std::function<void(const Framebuffer&)> write) {
  preview_.emplace(Preview{picture, picture, std::chrono::duration<double>(seconds),
                           std::chrono::steady_clock::now(), std::move(write)});
}

bool RenderWatch::block_wanted(const PixelWindow& block) {
  if (!state_ || !state_->has(block)) return true;
  progress_.add(pixels_in_window(block));
  return false;
}

void RenderWatch::block_done(const PixelWindow& block) {
  if (state_) state_->block_done(block);
  if (preview_) update_preview(block);
  progress_.add(pixels_in_window(block));
}

void RenderWatch::update_preview(const PixelWindow& block) {
  const std::lock_guard lock(preview_mutex_);
  for (int y = block.top; y < block.bottom; ++y) {
    for (int x = block.left; x < block.right; ++x) {
      preview_->finished.at(x, y) = preview_->picture.at(x, y);
    }
  }
  const auto now = std::chrono::steady_clock::now();
  if (now - preview_->last < preview_->interval) return;
  preview_->write(preview_->finished);
  preview_->last = std::chrono::steady_clock::now();
}

}  // namespace durer
