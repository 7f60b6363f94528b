#include "cli/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace durer {

void limit_memory(double megabytes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  // The sanitizers map terabytes that they never use.
  static_cast<void>(megabytes);
#else
  double bytes = megabytes * 1048576;
  if (bytes <= 0) {
    bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  }
  rlimit limit;
  if (bytes <= 0 || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, static_cast<rlim_t>(std::min(bytes, 9e18)));
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

}  // namespace durer
