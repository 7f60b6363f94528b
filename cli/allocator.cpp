// The command's memory comes from jemalloc. The first touch of a page costs more than filling it, and
// scenes of 100,000 objects touch tens of thousands: what jemalloc hands out in pieces is asked of the
// kernel by the piece (docs/decisions/0061-memory-from-jemalloc.md). The library looks for this name.
#include <jemalloc/jemalloc.h>
#include <sys/mman.h>

extern "C" {
extern const char* malloc_conf;
const char* malloc_conf = "oversize_threshold:0,lg_extent_max_active_fit:14";
}

namespace {

// Long vectors are often made longer than they will be used.
constexpr size_t kLongestFilled = size_t{4} << 20;

extent_hooks_t hooks;
extent_alloc_t* take_from_system = nullptr;

void* take_uncommitted(extent_hooks_t* by, void* address, size_t size, size_t alignment, bool* zero,
                       bool* commit, unsigned arena) {
  void* const piece = take_from_system(by, address, size, alignment, zero, commit, arena);
  *commit = false;  // jemalloc says which parts it hands out
  return piece;
}

// A hint: where the kernel knows none such, pages come as they are touched.
bool commit_pages(extent_hooks_t*, void* piece, size_t, size_t offset, size_t length, unsigned) {
  if (length <= kLongestFilled) {
    madvise(static_cast<char*>(piece) + offset, length, MADV_POPULATE_WRITE);
  }
  return false;
}

const bool kIsSetUp = [] {
  extent_hooks_t* in_use = nullptr;
  size_t size = sizeof in_use;
  if (mallctl("arena.0.extent_hooks", &in_use, &size, nullptr, 0) != 0) return false;
  hooks = *in_use;
  take_from_system = hooks.alloc;
  hooks.alloc = take_uncommitted;
  hooks.commit = commit_pages;
  in_use = &hooks;
  return mallctl("arena.0.extent_hooks", nullptr, nullptr, &in_use, sizeof in_use) == 0;
}();

}  // namespace
