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
extent_commit_t* commit_in_system = nullptr;
// Where the kernel promises no more memory than it has (vm.overcommit_memory = 2), pieces cannot be used
// before they are committed.
bool needs_commit = false;

void* take_uncommitted(extent_hooks_t* by, void* address, size_t size, size_t alignment, bool* zero,
                       bool* commit, unsigned arena) {
  void* const piece = take_from_system(by, address, size, alignment, zero, commit, arena);
  *commit = false;  // jemalloc says which parts it hands out
  return piece;
}

// True: there is no such memory. Asking for its pages is a hint: where the kernel knows none such, they
// come as they are touched.
bool commit_pages(extent_hooks_t* by, void* piece, size_t size, size_t offset, size_t length,
                  unsigned arena) {
  if (needs_commit && commit_in_system(by, piece, size, offset, length, arena)) return true;
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
  commit_in_system = hooks.commit;
  constexpr size_t kPage = 4096;
  bool is_zero = false, is_committed = false;
  void* const page =
      take_from_system(in_use, nullptr, kPage, kPage, &is_zero, &is_committed, 0);
  if (!page) return false;
  munmap(page, kPage);
  needs_commit = !is_committed;
  hooks.alloc = take_uncommitted;
  hooks.commit = commit_pages;
  in_use = &hooks;
  return mallctl("arena.0.extent_hooks", nullptr, nullptr, &in_use, sizeof in_use) == 0;
}();

}  // namespace
