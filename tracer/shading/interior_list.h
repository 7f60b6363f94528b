// The interiors that a ray is in, in the order of entry (spec/shading.md 11.2). No heap: a ray deeper
// nested than kCapacity keeps its first kCapacity entries.
#pragma once

#include <cstdint>

namespace durer {

class InteriorList {
 public:
  static constexpr int kCapacity = 64;

  InteriorList() = default;
  InteriorList(const InteriorList& other) { *this = other; }
  InteriorList& operator=(const InteriorList& other) {
    count_ = other.count_;
    // Rays are seldom in more than two. Without a loop, which would be made a copy of bytes.
    if (count_ > 0) entry_[0] = other.entry_[0];
    if (count_ > 1) entry_[1] = other.entry_[1];
    for (int i = 2; i < count_; ++i) entry_[i] = other.entry_[i];
    return *this;
  }

  bool empty() const { return count_ == 0; }
  int size() const { return count_; }
  int operator[](int i) const { return entry_[i]; }
  int last() const { return entry_[count_ - 1]; }
  // Position of an interior, -1 if the ray is not in it.
  int find(int interior) const {
    for (int i = 0; i < count_; ++i) {
      if (entry_[i] == interior) return i;
    }
    return -1;
  }
  void append(int interior) {
    if (count_ < kCapacity) entry_[count_++] = interior;
  }
  void remove_at(int position) {
    --count_;
    for (int i = position; i < count_; ++i) entry_[i] = entry_[i + 1];
  }
  // Passing through a surface: leaves the interior if the ray is in it, else enters it.
  void toggle(int interior) {
    const int position = find(interior);
    if (position >= 0) {
      remove_at(position);
    } else {
      append(interior);
    }
  }
  const int* begin() const { return entry_; }
  const int* end() const { return entry_ + count_; }

 private:
  int count_ = 0;
  int entry_[kCapacity];
};

}  // namespace durer
