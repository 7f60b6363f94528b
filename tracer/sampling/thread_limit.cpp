#include "tracer/sampling/thread_limit.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace durer {

void limit_threads(int threads) {
  // Never destroyed: when a limit goes, oneTBB starts the threads that were asked for meanwhile.
  static auto* const limits = new std::vector<std::unique_ptr<tbb::global_control>>;
  limits->push_back(std::make_unique<tbb::global_control>(
      tbb::global_control::max_allowed_parallelism, static_cast<size_t>(std::max(threads, 1))));
}

}  // namespace durer
