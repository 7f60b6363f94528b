// The command's memory comes from jemalloc, in pages of 2 MB: every first touch of a 4 KB page costs
// more than filling it, and scenes of 100,000 objects touch tens of thousands
// (docs/decisions/0061-memory-from-jemalloc.md). The library looks for this name.
#include <jemalloc/jemalloc.h>

extern "C" {
extern const char* malloc_conf;
const char* malloc_conf = "thp:always,oversize_threshold:0,lg_extent_max_active_fit:14";
}

namespace {

// jemalloc asks the system for pieces of 2, 2.5, 3, 3.5 MB and so on: where one begins or ends amid a
// page of 2 MB, that one falls apart into 512. Past 14 MB all are whole: the first piece is so large.
// Nothing of it is touched here.
const bool kStartsWithWholePages = [] {
  constexpr size_t kFirstPiece = size_t{14} << 20;
  if (void* piece = mallocx(kFirstPiece, MALLOCX_TCACHE_NONE)) dallocx(piece, MALLOCX_TCACHE_NONE);
  return mallctl("arena.0.purge", nullptr, nullptr, nullptr, 0) == 0;
}();

}  // namespace
