// A value that most nodes leave at its default: kept on the heap once it is set, shared by copies
// until one of them changes it. Scenes hold hundreds of thousands of nodes, most of them plain.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

namespace durer {

template <typename Value>
class Rare {
 public:
  Rare() = default;
  Rare(Value value) : kept_(new Kept{1, std::move(value)}) {}
  Rare(const Rare& other) : kept_(other.kept_) {
    if (kept_) kept_->owners.fetch_add(1, std::memory_order_relaxed);
  }
  Rare(Rare&& other) noexcept : kept_(std::exchange(other.kept_, nullptr)) {}
  Rare& operator=(Rare other) noexcept {
    std::swap(kept_, other.kept_);
    return *this;
  }
  ~Rare() {
    if (kept_ && kept_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete kept_;
  }

  const Value& get() const {
    static const Value kDefault{};
    return kept_ ? kept_->value : kDefault;
  }
  operator const Value&() const { return get(); }
  const Value& operator*() const { return get(); }
  const Value* operator->() const { return &get(); }
  // For changes: from now on this copy has a value of its own.
  Value& edit() {
    if (!kept_ || kept_->owners.load(std::memory_order_acquire) > 1) *this = Rare(Value(get()));
    return kept_->value;
  }

 private:
  struct Kept {
    std::atomic<uint32_t> owners;
    Value value;
  };
  Kept* kept_ = nullptr;  // one word: half a std::shared_ptr
};

}  // namespace durer
