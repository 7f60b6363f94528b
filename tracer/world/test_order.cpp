#include "tracer/world/test_order.h"

#include <atomic>

namespace durer {
namespace {

// How far the walk of a thread's last ray has been followed.
struct Walk {
  uint64_t order = 0;  // TestOrder's number
  Vec3 origin, direction;
  BoxWalk boxes;
  // When each object had its turn, counted over all walks; turns up to `start` are of earlier ones.
  std::vector<uint64_t> turn;
  uint64_t start = 0, last_turn = 0;

  bool has_tested(uint32_t object) const { return turn[object] > start; }
};

}  // namespace

TestOrder::TestOrder(const std::vector<FloatBox>& boxes) : hierarchy_(boxes) {
  static std::atomic<uint64_t> count = 0;
  number_ = ++count;
}

bool TestOrder::is_tested_first(uint32_t a, uint32_t b, const Vec3& origin,
                                const Vec3& direction) const {
  thread_local Walk walk;
  if (walk.order != number_ || walk.origin != origin || walk.direction != direction) {
    walk.order = number_;
    walk.origin = origin;
    walk.direction = direction;
    // Objects are the first nodes.
    const size_t count = hierarchy_.nodes().size();
    if (walk.turn.size() < count) walk.turn.resize(count);
    walk.start = walk.last_turn;
    walk.boxes.start(hierarchy_, origin, direction);
  }
  while (!walk.has_tested(a) && !walk.has_tested(b)) {
    if (walk.boxes.is_over()) return a < b;
    double key;
    const BoxHierarchy::Node& node = walk.boxes.next(key);
    if (node.element >= 0) walk.turn[static_cast<size_t>(node.element)] = ++walk.last_turn;
  }
  return walk.has_tested(a) && (!walk.has_tested(b) || walk.turn[a] < walk.turn[b]);
}

}  // namespace durer
