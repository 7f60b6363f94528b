#include "cli/render_watch.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace durer {
namespace {

int64_t area(const PixelWindow& window) {
  return static_cast<int64_t>(window.width()) * window.height();
}

}  // namespace

// The picture as far as its blocks are finished; the others, which threads may be storing, are black.
class RenderWatch::FinishedBlocks : public Picture {
 public:
  FinishedBlocks(const Picture& picture, int block_size)
      : picture_(picture),
        size_(block_size),
        columns_((picture.width() + block_size - 1) / block_size),
        done_(static_cast<size_t>(columns_) *
              static_cast<size_t>((picture.height() + block_size - 1) / block_size)) {}

  void mark(const PixelWindow& block) {
    done_[index(block.left, block.top)].store(true, std::memory_order_release);
  }

  int width() const override { return picture_.width(); }
  int height() const override { return picture_.height(); }
  void store(const Framebuffer&) override { throw std::logic_error("a preview is only read"); }
  void read(int y, int left, int right, PixelColor* out) const override {
    while (left < right) {
      const int end = std::min(right, (left / size_ + 1) * size_);
      if (done_[index(left, y)].load(std::memory_order_acquire)) {
        picture_.read(y, left, end, out);
      } else {
        std::fill_n(out, end - left, PixelColor());
      }
      out += end - left;
      left = end;
    }
  }

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y / size_) * static_cast<size_t>(columns_) +
           static_cast<size_t>(x / size_);
  }

  const Picture& picture_;
  const int size_, columns_;
  std::vector<std::atomic<bool>> done_;
};

void RenderWatch::preview(const Picture& picture, int block_size, double seconds,
                          std::function<void(const Picture&)> write) {
  preview_.emplace(Preview{std::make_shared<FinishedBlocks>(picture, block_size),
                           std::chrono::duration<double>(seconds),
                           std::chrono::steady_clock::now(), std::move(write)});
}

bool RenderWatch::block_wanted(const PixelWindow& block) {
  if (!state_ || !state_->has(block)) return true;
  if (preview_) preview_->finished->mark(block);
  progress_.add(area(block));
  return false;
}

void RenderWatch::block_done(const Framebuffer& block) {
  if (state_ && !state_->add(block)) {
    warn_("the finished blocks cannot be kept any more (" + std::string(std::strerror(errno)) +
          "); the render goes on, but if it is stopped, +C can only continue from here");
  }
  if (preview_) {
    preview_->finished->mark(block.window());
    update_preview();
  }
  progress_.add(area(block.window()));
}

void RenderWatch::update_preview() {
  // Whoever finds the lock taken goes on rendering.
  const std::unique_lock lock(preview_mutex_, std::try_to_lock);
  if (!lock || preview_->failed) return;
  if (std::chrono::steady_clock::now() - preview_->last < preview_->interval) return;
  try {
    preview_->write(*preview_->finished);
  } catch (const std::exception& error) {
    preview_->failed = true;
    warn_("no more previews: " + std::string(error.what()));
  }
  preview_->last = std::chrono::steady_clock::now();
}

}  // namespace durer
