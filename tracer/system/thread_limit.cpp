#include "tracer/system/thread_limit.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>

namespace durer {
namespace {

std::atomic<int> wanted{0};  // 0: nobody has said

}  // namespace

void limit_threads(int threads) { wanted = std::max(threads, 1); }

void enforce_thread_limit() {
  if (wanted == 0) return;
  // Never destroyed: when a limit goes, oneTBB starts the threads that were asked for meanwhile.
  [[maybe_unused]] static const void* const volatile limit = new tbb::global_control(
      tbb::global_control::max_allowed_parallelism, static_cast<size_t>(wanted));
}

}  // namespace durer
