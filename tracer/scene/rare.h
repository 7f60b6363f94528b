// A value that most nodes leave at its default: kept on the heap once it is set, shared by copies
// until one of them changes it. Scenes hold hundreds of thousands of nodes, most of them plain.
#pragma once

#include <memory>
#include <utility>

namespace durer {

template <typename Value>
class Rare {
 public:
  Rare() = default;
  Rare(Value value) : value_(std::make_shared<Value>(std::move(value))) {}

  const Value& get() const {
    static const Value kDefault{};
    return value_ ? *value_ : kDefault;
  }
  operator const Value&() const { return get(); }
  const Value& operator*() const { return get(); }
  const Value* operator->() const { return &get(); }
  // For changes: from now on this copy has a value of its own.
  Value& edit() {
    if (!value_) {
      value_ = std::make_shared<Value>();
    } else if (value_.use_count() > 1) {
      value_ = std::make_shared<Value>(*value_);
    }
    return *value_;
  }

 private:
  std::shared_ptr<Value> value_;
};

}  // namespace durer
