// Preloaded into durer: counts what its first thread allocates by malloc, operator new and their kin,
// whichever library serves them, and writes the count at the end to the file named by ALLOCATION_COUNT.
// With +WT1 that thread follows all rays; what others do (OpenImageIO starts some) varies from run to run.
#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace {
std::atomic<unsigned long> count{0};

void count_one() {
  enum : char { unknown, first, other };
  [[gnu::tls_model("initial-exec")]] static thread_local char thread = unknown;
  if (thread == unknown) thread = gettid() == getpid() ? first : other;
  if (thread == first) count.fetch_add(1, std::memory_order_relaxed);
}

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
  count_one();
  return real(size);
}
void* realloc(void* block, size_t size) {
  static const auto real = next<void* (*)(void*, size_t)>("realloc");
  count_one();
  return real(block, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  static const auto real = next<void* (*)(size_t, size_t)>("aligned_alloc");
  count_one();
  return real(alignment, size);
}
int posix_memalign(void** block, size_t alignment, size_t size) {
  static const auto real = next<int (*)(void**, size_t, size_t)>("posix_memalign");
  count_one();
  return real(block, alignment, size);
}
}

// The nothrow forms are not used.
void* operator new(size_t size) {
  static const auto real = next<void* (*)(size_t)>("_Znwm");
  count_one();
  return real(size);
}
void* operator new[](size_t size) {
  static const auto real = next<void* (*)(size_t)>("_Znam");
  count_one();
  return real(size);
}
void* operator new(size_t size, std::align_val_t alignment) {
  static const auto real = next<void* (*)(size_t, std::align_val_t)>("_ZnwmSt11align_val_t");
  count_one();
  return real(size, alignment);
}
