#include "tracer/world/test_order.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace durer {
namespace {

// A node holds up to this many without a further split.
constexpr uint32_t kMostInBundle = 4;
constexpr double kInfiniteKey = -1e7;

float upper(const FloatBox& box, int axis) { return box.lower[axis] + box.length[axis]; }

void extend(FloatBox& box, const FloatBox& other) {
  for (int i = 0; i < 3; ++i) {
    const float low = std::min(box.lower[i], other.lower[i]);
    box.length[i] = std::max(upper(box, i), upper(other, i)) - low;
    box.lower[i] = low;
  }
}

float half_area(const FloatBox& box) {
  return box.length[0] * (box.length[1] + box.length[2]) + box.length[1] * box.length[2];
}

// A ray in the precision in which boxes are kept.
struct FloatRay {
  FloatRay(const Vec3& o, const Vec3& d) {
    for (int i = 0; i < 3; ++i) {
      origin[i] = static_cast<float>(o[i]);
      is_zero[i] = d[i] == 0;
      inverse[i] = is_zero[i] ? 0 : static_cast<float>(1 / d[i]);
    }
  }
  float origin[3], inverse[3];
  bool is_zero[3];
};

// Where the ray enters a box, negative behind its origin; false: it does not meet it. The ways to the
// near corner and along the edge are rounded to single precision, their sum is not.
bool enters(const FloatBox& box, const FloatRay& ray, double& key) {
  double enter = -2e10, leave = 2e10;
  for (int i = 0; i < 3; ++i) {
    const float low = box.lower[i], high = upper(box, i), o = ray.origin[i];
    if (ray.is_zero[i]) {
      if (o < low || o > high) return false;
      continue;
    }
    const double lower = (low - o) * ray.inverse[i];
    const double higher = lower + box.length[i] * ray.inverse[i];
    enter = std::max(enter, std::min(lower, higher));
    leave = std::min(leave, std::max(lower, higher));
    if (leave < 1e-10 || enter > leave) return false;
  }
  key = enter;
  return true;
}

// The reference's heap: which of two equal keys leaves first is its own affair.
class Heap {
 public:
  void clear() { items_.assign(1, {}); }
  bool is_empty() const { return items_.size() == 1; }
  void push(double key, uint32_t node) {
    items_.emplace_back(key, node);
    size_t i = items_.size() - 1;
    for (; i > 1 && items_[i].first < items_[i / 2].first; i /= 2) {
      std::swap(items_[i], items_[i / 2]);
    }
  }
  uint32_t pop() {
    const uint32_t node = items_[1].second;
    items_[1] = items_.back();
    items_.pop_back();
    for (size_t i = 1; 2 * i < items_.size();) {
      size_t child = 2 * i;
      if (child + 1 < items_.size() && !(items_[child].first < items_[child + 1].first)) ++child;
      if (!(items_[i].first > items_[child].first)) break;
      std::swap(items_[i], items_[child]);
      i = child;
    }
    return node;
  }

 private:
  std::vector<std::pair<double, uint32_t>> items_;  // from place 1 on
};

// How far the walk of a thread's last ray has been followed.
struct Walk {
  uint64_t order = 0;  // TestOrder's number
  Vec3 origin, direction;
  Heap heap;
  // When each object had its turn, counted over all walks; turns up to `start` are of earlier ones.
  std::vector<uint64_t> turn;
  uint64_t start = 0, last_turn = 0;

  bool has_tested(uint32_t object) const { return turn[object] > start; }
};

}  // namespace

TestOrder::TestOrder(const std::vector<FloatBox>& boxes) {
  static std::atomic<uint64_t> count = 0;
  number_ = ++count;
  std::vector<uint32_t> infinite;
  for (size_t i = 0; i < boxes.size(); ++i) {
    Node leaf;
    leaf.box = boxes[i];
    leaf.object = static_cast<int64_t>(i);
    leaf.is_infinite = boxes[i].is_infinite();
    const uint32_t number = static_cast<uint32_t>(nodes_.size());
    nodes_.push_back(leaf);
    (leaf.is_infinite ? infinite : list_).push_back(number);
  }
  const bool any_finite = !list_.empty();
  if (any_finite) build(static_cast<uint32_t>(list_.size()));
  if (infinite.empty()) return;
  // Infinite objects are the first entry of the root.
  const auto add = [&](const std::vector<uint32_t>& inside) {
    Node node;
    node.is_infinite = true;
    node.first = static_cast<uint32_t>(entries_.size());
    node.count = static_cast<uint32_t>(inside.size());
    entries_.insert(entries_.end(), inside.begin(), inside.end());
    nodes_.push_back(node);
    return static_cast<uint32_t>(nodes_.size() - 1);
  };
  const uint32_t unbounded = add(infinite);
  if (!any_finite) {
    root_ = unbounded;
    return;
  }
  std::vector<uint32_t> inside{unbounded};
  const Node& top = nodes_[root_];
  inside.insert(inside.end(), entries_.begin() + top.first,
                entries_.begin() + top.first + top.count);
  root_ = add(inside);
}

void TestOrder::build(uint32_t finite_count) {
  uint32_t first = 0, last = finite_count;
  // The nodes of one pass are what the next one splits.
  while (split(first, last)) {
    first = last;
    last = static_cast<uint32_t>(list_.size());
  }
  root_ = list_.back();
}

void TestOrder::bundle(uint32_t first, uint32_t last) {
  Node node;
  node.box = nodes_[list_[first]].box;
  node.first = static_cast<uint32_t>(entries_.size());
  node.count = last - first;
  for (uint32_t i = first; i < last; ++i) {
    extend(node.box, nodes_[list_[i]].box);
    entries_.push_back(list_[i]);
  }
  list_.push_back(static_cast<uint32_t>(nodes_.size()));
  nodes_.push_back(node);
}

// True if the range became several nodes.
bool TestOrder::split(uint32_t first, uint32_t last) {
  const auto box = [&](uint32_t i) -> const FloatBox& { return nodes_[list_[i]].box; };
  // The axis along which the lower corners spread most, by the reference's measure.
  int axis = 0;
  float widest = -2e10f;
  for (int a = 0; a < 3; ++a) {
    float low = 2e10f, high = -2e10f;
    for (uint32_t i = first; i < last; ++i) {
      low = std::min(low, box(i).lower[a]);
      if (upper(box(i), a) > high) high = box(i).lower[a];
    }
    if (high - low > widest) {
      widest = high - low;
      axis = a;
    }
  }
  std::stable_sort(list_.begin() + first, list_.begin() + last, [&](uint32_t i, uint32_t j) {
    const FloatBox &a = nodes_[i].box, &b = nodes_[j].box;
    return 2 * a.lower[axis] + a.length[axis] < 2 * b.lower[axis] + b.length[axis];
  });

  const uint32_t n = last - first;
  std::vector<float> left(n), right(n);
  FloatBox joined = box(first);
  for (uint32_t i = 0; i < n; ++i) {
    extend(joined, box(first + i));
    left[i] = half_area(joined);
  }
  joined = box(last - 1);
  for (uint32_t i = n; i-- > 0;) {
    extend(joined, box(first + i));
    right[i] = half_area(joined);
  }
  float best = right[0] * (static_cast<float>(n) - 3);
  int64_t place = -1;
  for (uint32_t i = 0; i + 1 < n; ++i) {
    const float cost = static_cast<float>(i + 1) * left[i] + static_cast<float>(n - 1 - i) * right[i + 1];
    if (cost < best) {
      best = cost;
      place = i;
    }
  }
  if (n <= kMostInBundle || place < 0) {
    bundle(first, last);
    return false;
  }
  const uint32_t middle = first + static_cast<uint32_t>(place) + 1;
  split(first, middle);
  split(middle, last);
  return true;
}

bool TestOrder::is_tested_first(uint32_t a, uint32_t b, const Vec3& origin,
                                const Vec3& direction) const {
  thread_local Walk walk;
  const FloatRay ray(origin, direction);
  const auto enter = [&](uint32_t i) {
    double key = kInfiniteKey;
    if (nodes_[i].is_infinite || enters(nodes_[i].box, ray, key)) walk.heap.push(key, i);
  };
  if (walk.order != number_ || walk.origin != origin || walk.direction != direction) {
    walk.order = number_;
    walk.origin = origin;
    walk.direction = direction;
    walk.heap.clear();
    // Objects are the first nodes.
    if (walk.turn.size() < nodes_.size()) walk.turn.resize(nodes_.size());
    walk.start = walk.last_turn;
    enter(root_);
  }
  while (!walk.has_tested(a) && !walk.has_tested(b)) {
    if (walk.heap.is_empty()) return a < b;
    const Node& node = nodes_[walk.heap.pop()];
    if (node.object >= 0) walk.turn[static_cast<size_t>(node.object)] = ++walk.last_turn;
    for (uint32_t i = 0; i < node.count; ++i) enter(entries_[node.first + i]);
  }
  return walk.has_tested(a) && (!walk.has_tested(b) || walk.turn[a] < walk.turn[b]);
}

}  // namespace durer
