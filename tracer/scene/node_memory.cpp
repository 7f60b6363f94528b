#include "tracer/scene/node_memory.h"

#include <atomic>
#include <cstdint>
#include <new>

namespace durer {
namespace {

constexpr size_t kBlockSize = 64 * 1024;
// Larger nodes would leave too much of a block empty. Sanitizers want each node apart.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr size_t kLargestNode = 0;
#else
constexpr size_t kLargestNode = kBlockSize / 32;
#endif

struct Block {
  // Nodes that live in it; while it is being filled, this many more.
  static constexpr uint32_t kOpen = 1u << 30;
  std::atomic<uint32_t> nodes{kOpen};

  void let_go(uint32_t count) {
    if (nodes.fetch_sub(count, std::memory_order_acq_rel) == count) ::operator delete(this);
  }
};

// Before each node.
struct Header {
  Block* block;
};
static_assert(sizeof(Header) == kNodeAlignment && sizeof(Block) <= kNodeAlignment);

// The block that a thread fills.
class Filling {
 public:
  ~Filling() { close(); }

  void* take(size_t bytes) {
    bytes = sizeof(Header) + ((bytes + kNodeAlignment - 1) & ~(kNodeAlignment - 1));
    if (!block_ || used_ + bytes > kBlockSize) open();
    Header* const header = new (reinterpret_cast<char*>(block_) + used_) Header{block_};
    used_ += bytes;
    ++taken_;
    return header + 1;
  }

 private:
  void open() {
    close();
    block_ = new (::operator new(kBlockSize)) Block;
    used_ = kNodeAlignment;
  }
  void close() {
    if (block_) block_->let_go(Block::kOpen - taken_);
    block_ = nullptr;
    taken_ = 0;
  }

  Block* block_ = nullptr;
  size_t used_ = 0;
  uint32_t taken_ = 0;
};

thread_local Filling filling;

}  // namespace

void* take_node_memory(size_t bytes) {
  return bytes > kLargestNode ? ::operator new(bytes) : filling.take(bytes);
}

void give_node_memory(void* memory, size_t bytes) {
  if (bytes > kLargestNode) {
    ::operator delete(memory);
  } else {
    (static_cast<Header*>(memory) - 1)->block->let_go(1);
  }
}

}  // namespace durer
