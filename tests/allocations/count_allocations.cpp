// Preloaded into durer: counts calls of malloc and its kin, and writes the count at the end to the
// file named by ALLOCATION_COUNT.
#include <dlfcn.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace {
std::atomic<unsigned long> count{0};

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

struct AtExit {
  ~AtExit() {
    const char* path = std::getenv("ALLOCATION_COUNT");
    const unsigned long total = count;
    if (!path) return;
    if (std::FILE* file = std::fopen(path, "w")) {
      std::fprintf(file, "%lu\n", total);
      std::fclose(file);
    }
  }
} at_exit;
}  // namespace

extern "C" {
void* __libc_malloc(size_t size);
void* __libc_realloc(void* block, size_t size);

void* malloc(size_t size) {
  count.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
void* realloc(void* block, size_t size) {
  count.fetch_add(1, std::memory_order_relaxed);
  return __libc_realloc(block, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  static const auto real = next<void* (*)(size_t, size_t)>("aligned_alloc");
  count.fetch_add(1, std::memory_order_relaxed);
  return real(alignment, size);
}
int posix_memalign(void** block, size_t alignment, size_t size) {
  static const auto real = next<int (*)(void**, size_t, size_t)>("posix_memalign");
  count.fetch_add(1, std::memory_order_relaxed);
  return real(block, alignment, size);
}
}
