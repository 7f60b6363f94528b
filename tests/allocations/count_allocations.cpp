// Preloaded into durer: counts what is allocated by malloc, operator new and their kin, whichever
// library serves them, and writes the count at the end to the file named by ALLOCATION_COUNT.
#include <dlfcn.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

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
void* malloc(size_t size) {
  static const auto real = next<void* (*)(size_t)>("malloc");
  count.fetch_add(1, std::memory_order_relaxed);
  return real(size);
}
void* realloc(void* block, size_t size) {
  static const auto real = next<void* (*)(void*, size_t)>("realloc");
  count.fetch_add(1, std::memory_order_relaxed);
  return real(block, size);
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

// The nothrow forms are not used.
void* operator new(size_t size) {
  static const auto real = next<void* (*)(size_t)>("_Znwm");
  count.fetch_add(1, std::memory_order_relaxed);
  return real(size);
}
void* operator new[](size_t size) {
  static const auto real = next<void* (*)(size_t)>("_Znam");
  count.fetch_add(1, std::memory_order_relaxed);
  return real(size);
}
void* operator new(size_t size, std::align_val_t alignment) {
  static const auto real = next<void* (*)(size_t, std::align_val_t)>("_ZnwmSt11align_val_t");
  count.fetch_add(1, std::memory_order_relaxed);
  return real(size, alignment);
}
