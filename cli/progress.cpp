#include "cli/progress.h"

#include <algorithm>
#include <cstdio>

namespace durer {
namespace {

constexpr double kFirstBar = 0.1, kBarInterval = 0.1;    // seconds
constexpr double kFirstLine = 2.0, kLineInterval = 5.0;

// Time left, once enough is done to tell.
std::string time_left(double share, double seconds) {
  if (share < 0.02 || seconds < 0.3) return "";
  return ", about " + duration_text(seconds / share * (1 - share)) + " left";
}

}  // namespace

std::string progress_bar(double share, double seconds, int columns) {
  char percent[16];
  std::snprintf(percent, sizeof percent, "%3d %% ", static_cast<int>(share * 100));
  std::string tail = " " + duration_text(seconds);
  const std::string left = time_left(share, seconds);
  if (6 + tail.size() + left.size() < static_cast<size_t>(columns)) tail += left;
  const int room = columns - 1 - static_cast<int>(tail.size()) - 6 - 2;
  const int width = std::clamp(room, 0, 40);
  const int filled = static_cast<int>(share * width);
  std::string bar = percent;
  if (width >= 4) {
    bar += "[" + std::string(static_cast<size_t>(filled), '#') +
           std::string(static_cast<size_t>(width - filled), ' ') + "]";
  }
  return bar + tail;
}

Progress::Progress(Console& console, int64_t pixels, bool shown)
    : console_(console),
      pixels_(std::max<int64_t>(pixels, 1)),
      shown_(shown),
      terminal_(shown && console.is_terminal()),
      begin_(std::chrono::steady_clock::now()),
      next_show_(terminal_ ? kFirstBar : kFirstLine) {}

double Progress::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Progress::add(int64_t pixels) {
  const int64_t done = done_.fetch_add(pixels) + pixels;
  if (!shown_) return;
  // Whoever finds the lock taken goes on rendering: the holder prints.
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return;
  const double now = seconds();
  if (now < next_show_) return;
  next_show_ = now + (terminal_ ? kBarInterval : kLineInterval);
  show(static_cast<double>(done) / static_cast<double>(pixels_), now);
}

void Progress::show(double share, double seconds) {
  if (terminal_) {
    console_.status(progress_bar(share, seconds, console_.columns()));
    bar_shown_ = true;
    return;
  }
  console_.line(Stream::render, std::to_string(static_cast<int>(share * 100)) + " % after " +
                                    duration_text(seconds) + time_left(share, seconds));
}

void Progress::finish() {
  const std::lock_guard lock(mutex_);
  if (bar_shown_) console_.status("");
  bar_shown_ = false;
}

}  // namespace durer
