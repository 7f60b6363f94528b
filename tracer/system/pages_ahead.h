// Pages of long vectors, asked of the kernel by the piece just before they are written: that costs half
// as much as touching each (docs/decisions/0061-memory-from-jemalloc.md). Only a hint: where the kernel
// knows none such, pages come as they are touched.
#pragma once

#include <cstddef>
#include <vector>

namespace durer {

// One per vector that fills from front to back.
class PagesAhead {
 public:
  // To be called before each push_back.
  template <typename T>
  void before_push(const std::vector<T>& vector) {
    const char* const place = reinterpret_cast<const char*>(vector.data() + vector.size());
    if (place >= begin_ && place < end_) [[likely]] return;
    ask(place, reinterpret_cast<const char*>(vector.data() + vector.capacity()));
  }

 private:
  void ask(const char* place, const char* end);

  // What needs no asking.
  const char *begin_ = nullptr, *end_ = nullptr;
};

}  // namespace durer
