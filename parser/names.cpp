#include "parser/names.h"

#include <cstring>

namespace durer {
namespace {

uint32_t hash_of(const char* text, size_t length) {
  uint32_t hash = 2166136261u;  // FNV-1a
  for (size_t i = 0; i < length; ++i) hash = (hash ^ static_cast<unsigned char>(text[i])) * 16777619u;
  return hash;
}

}  // namespace

NameTable::NameTable() {
  slots_.resize(4096);
  for (int i = 0; i < kKeywordCount; ++i) intern(spelling(static_cast<Keyword>(i)));
}

Name NameTable::intern(const char* text, size_t length) {
  const uint32_t hash = hash_of(text, length);
  const size_t mask = slots_.size() - 1;
  size_t at = hash & mask;
  for (; slots_[at].name_plus_one; at = (at + 1) & mask) {
    if (slots_[at].hash != hash) continue;
    const std::string_view known = texts_[slots_[at].name_plus_one - 1];
    if (known.size() == length && std::memcmp(known.data(), text, length) == 0) {
      return slots_[at].name_plus_one - 1;
    }
  }
  const Name name = static_cast<Name>(texts_.size());
  texts_.emplace_back(keep(text, length), length);
  slots_[at] = {hash, name + 1};
  if (texts_.size() * 2 > slots_.size()) grow();
  return name;
}

void NameTable::grow() {
  std::vector<Slot> old(slots_.size() * 2);
  old.swap(slots_);
  const size_t mask = slots_.size() - 1;
  for (const Slot& slot : old) {
    if (!slot.name_plus_one) continue;
    size_t at = slot.hash & mask;
    while (slots_[at].name_plus_one) at = (at + 1) & mask;
    slots_[at] = slot;
  }
}

const char* NameTable::keep(const char* text, size_t length) {
  if (chunk_used_ + length > chunk_size_) {
    chunk_size_ = length > 16384 ? length : 16384;
    chunks_.push_back(std::make_unique<char[]>(chunk_size_));
    chunk_used_ = 0;
  }
  char* kept = chunks_.back().get() + chunk_used_;
  std::memcpy(kept, text, length);
  chunk_used_ += length;
  return kept;
}

}  // namespace durer
