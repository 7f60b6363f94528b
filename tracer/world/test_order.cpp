#include "tracer/world/test_order.h"

#include <atomic>

namespace durer {
namespace {

// How far the walk of a thread's last ray has been followed.
struct Walk {
  uint64_t order = 0;  // TestOrder's number
  Vec3 origin, direction;
  BoxWalk boxes;
  std::vector<double> keys;  // of the nodes that had their turn, in this order
  // When each object had its turn, counted over all walks; turns up to `start` are of earlier ones.
  std::vector<uint64_t> turn;
  uint64_t start = 0;

  bool has_tested(uint32_t object) const { return turn[object] > start; }
  uint64_t last_turn() const { return start + keys.size(); }

  // False at the end.
  bool go_on() {
    if (boxes.is_over()) return false;
    double key;
    const BoxHierarchy::Node& node = boxes.next(key);
    keys.push_back(key);
    if (node.element >= 0) turn[static_cast<size_t>(node.element)] = last_turn();
    return true;
  }

  // Whether the second of two objects has its turn although the first was met at `depth`: the walk
  // ends at the first box that lies beyond.
  bool comes_to(uint32_t second, uint32_t first, double depth) {
    for (uint64_t turns = turn[first];; ++turns) {
      if (turn[second] == turns) return true;
      if (turns == last_turn() && !go_on()) return false;
      if (keys[turns - start] > depth) return false;
    }
  }
};

}  // namespace

TestOrder::TestOrder(const std::vector<FloatBox>& boxes)
    : hierarchy_(boxes), ranks_(boxes.size()) {
  static std::atomic<uint64_t> count = 0;
  number_ = ++count;
  if (boxes.empty()) return;
  std::vector<uint32_t> ahead{hierarchy_.root()};
  uint32_t rank = 0;
  while (!ahead.empty()) {
    const BoxHierarchy::Node& node = hierarchy_.nodes()[ahead.back()];
    ahead.pop_back();
    if (node.element >= 0) ranks_[static_cast<size_t>(node.element)] = rank++;
    for (uint32_t i = node.count; i-- > 0;) ahead.push_back(hierarchy_.entries()[node.first + i]);
  }
}

bool TestOrder::shows_first(uint32_t a, double depth_a, uint32_t b, double depth_b,
                            const Vec3& origin, const Vec3& direction) const {
  thread_local Walk walk;
  if (walk.order != number_ || walk.origin != origin || walk.direction != direction) {
    walk.order = number_;
    walk.origin = origin;
    walk.direction = direction;
    // Objects are the first nodes.
    const size_t count = hierarchy_.nodes().size();
    if (walk.turn.size() < count) walk.turn.resize(count);
    walk.start = walk.last_turn();
    walk.keys.clear();
    walk.boxes.start(hierarchy_, origin, direction);
  }
  while (!walk.has_tested(a) && !walk.has_tested(b)) {
    if (!walk.go_on()) return depth_a < depth_b || (depth_a == depth_b && a < b);
  }
  if (walk.has_tested(a) && (!walk.has_tested(b) || walk.turn[a] < walk.turn[b])) {
    return depth_a <= depth_b || !walk.comes_to(b, a, depth_a);
  }
  return depth_a < depth_b && walk.comes_to(a, b, depth_b);
}

}  // namespace durer
