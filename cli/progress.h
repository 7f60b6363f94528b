// How far a render has come: a bar on a terminal, plain lines at intervals elsewhere.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

#include "cli/console.h"

namespace durer {

class Progress {
 public:
  // `shown` false (-V): nothing is printed.
  Progress(Console& console, int64_t pixels, bool shown);

  // From any thread.
  void add(int64_t pixels);
  // Takes the bar away.
  void finish();

  double seconds() const;

 private:
  void show(double share, double seconds);

  Console& console_;
  const int64_t pixels_;
  const bool shown_, terminal_;
  const std::chrono::steady_clock::time_point begin_;
  std::atomic<int64_t> done_{0};
  std::mutex mutex_;
  double next_show_;
  bool bar_shown_ = false;
};

// " 42 % [########            ] 1.2 s, about 2 s left", at most `columns` wide.
std::string progress_bar(double share, double seconds, int columns);

}  // namespace durer
