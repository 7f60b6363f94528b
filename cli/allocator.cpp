// The command's memory comes from jemalloc, in pages of 4 KB at first, then in pages of 2 MB. Every
// first touch of a 4 KB page costs more than filling it, and scenes of 100,000 objects touch tens
// of thousands; small scenes would clear pages of 2 MB of which they use little
// (docs/decisions/0061-memory-from-jemalloc.md). The library looks for this name.
#include <jemalloc/jemalloc.h>
#include <sys/mman.h>

extern "C" {
extern const char* malloc_conf;
const char* malloc_conf = "oversize_threshold:0,lg_extent_max_active_fit:14";
}

namespace {

extent_hooks_t hooks;
extent_alloc_t* take_from_system = nullptr;

void* take_in_large_pages(extent_hooks_t* by, void* address, size_t size, size_t alignment,
                          bool* zero, bool* commit, unsigned arena) {
  void* piece = take_from_system(by, address, size, alignment, zero, commit, arena);
  if (piece) madvise(piece, size, MADV_HUGEPAGE);
  return piece;
}

// jemalloc asks the system for pieces of 2, 2.5, 3, 3.5 MB and so on: where one begins or ends amid
// a page of 2 MB, that one falls apart into 512. Past 14 MB all are whole: the first piece is so
// large, and the one in small pages. Nothing of it is touched here.
const bool kIsSetUp = [] {
  constexpr size_t kFirstPiece = size_t{14} << 20;
  if (void* piece = mallocx(kFirstPiece, MALLOCX_TCACHE_NONE)) dallocx(piece, MALLOCX_TCACHE_NONE);
  mallctl("arena.0.purge", nullptr, nullptr, nullptr, 0);
  extent_hooks_t* in_use = nullptr;
  size_t size = sizeof in_use;
  if (mallctl("arena.0.extent_hooks", &in_use, &size, nullptr, 0) != 0) return false;
  hooks = *in_use;
  take_from_system = hooks.alloc;
  hooks.alloc = take_in_large_pages;
  in_use = &hooks;
  return mallctl("arena.0.extent_hooks", nullptr, nullptr, &in_use, sizeof in_use) == 0;
}();

}  // namespace
