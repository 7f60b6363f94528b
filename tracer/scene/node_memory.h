// Memory of the scene's nodes. A loop makes hundreds of thousands of them, and they are let go in the
// same order on their way into the world: taken from blocks that are freed as a whole, their memory
// serves the world again, in pieces of any size.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

namespace durer {

inline constexpr size_t kNodeAlignment = 8;

// Of any thread; freed by any.
void* take_node_memory(size_t bytes);
void give_node_memory(void* memory, size_t bytes);

template <typename T>
struct NodeAllocator {
  using value_type = T;

  NodeAllocator() = default;
  template <typename Other>
  NodeAllocator(const NodeAllocator<Other>&) {}

  T* allocate(size_t count) {
    static_assert(alignof(T) <= kNodeAlignment);
    return static_cast<T*>(take_node_memory(count * sizeof(T)));
  }
  void deallocate(T* memory, size_t count) { give_node_memory(memory, count * sizeof(T)); }
  bool operator==(const NodeAllocator&) const { return true; }
};

// As std::make_shared.
template <typename T, typename... Arguments>
std::shared_ptr<T> make_node(Arguments&&... arguments) {
  return std::allocate_shared<T>(NodeAllocator<std::remove_const_t<T>>(),
                                 std::forward<Arguments>(arguments)...);
}

}  // namespace durer
