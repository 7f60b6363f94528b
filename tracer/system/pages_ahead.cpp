#include "tracer/system/pages_ahead.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>

namespace durer {
namespace {

constexpr size_t kPage = 4096;
constexpr size_t kPiece = size_t{1} << 20;

}  // namespace

void PagesAhead::ask(const char* place, const char* end) {
  begin_ = place;
  end_ = place + std::min<size_t>(kPiece, end - place);
  // Whole pages only: what else lies on those at the ends is not ours to ask for.
  const size_t skipped = -reinterpret_cast<uintptr_t>(place) % kPage;
  const size_t length = end_ - place;
  if (length < kPiece / 16) return;
  madvise(const_cast<char*>(place) + skipped, (length - skipped) / kPage * kPage,
          MADV_POPULATE_WRITE);
}

}  // namespace durer
