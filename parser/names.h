// Interned names: every identifier of a parse is one small number, compared and looked up by it.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "parser/token.h"

namespace durer {

class NameTable {
 public:
  // Starts with the keywords: their names are their numbers.
  NameTable();

  Name intern(const char* text, size_t length);
  Name intern(std::string_view text) { return intern(text.data(), text.size()); }
  std::string_view text(Name name) const { return texts_[name]; }
  size_t size() const { return texts_.size(); }

 private:
  void grow();
  const char* keep(const char* text, size_t length);

  struct Slot {
    uint32_t hash = 0;
    uint32_t name_plus_one = 0;  // 0: empty
  };
  std::vector<Slot> slots_;  // open addressing, a power of two
  std::vector<std::string_view> texts_;
  std::vector<std::unique_ptr<char[]>> chunks_;
  size_t chunk_used_ = 0, chunk_size_ = 0;
};

}  // namespace durer
