#include "tracer/intersect/box_walk.h"

#include <algorithm>

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

}  // namespace

BoxHierarchy::BoxHierarchy(const std::vector<FloatBox>& boxes) {
  std::vector<uint32_t> infinite;
  for (size_t i = 0; i < boxes.size(); ++i) {
    Node leaf;
    leaf.box = boxes[i];
    leaf.element = static_cast<int64_t>(i);
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

void BoxHierarchy::build(uint32_t finite_count) {
  uint32_t first = 0, last = finite_count;
  // The nodes of one pass are what the next one splits.
  while (split(first, last)) {
    first = last;
    last = static_cast<uint32_t>(list_.size());
  }
  root_ = list_.back();
}

void BoxHierarchy::bundle(uint32_t first, uint32_t last) {
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
bool BoxHierarchy::split(uint32_t first, uint32_t last) {
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

void BoxWalk::start(const BoxHierarchy& hierarchy, const Vec3& origin, const Vec3& direction) {
  hierarchy_ = &hierarchy;
  for (int i = 0; i < 3; ++i) {
    // The precision in which boxes are kept.
    origin_[i] = static_cast<float>(origin[i]);
    is_zero_[i] = direction[i] == 0;
    inverse_[i] = is_zero_[i] ? 0 : static_cast<float>(1 / direction[i]);
  }
  heap_.assign(1, {});
  enter(hierarchy.root());
}

const BoxHierarchy::Node& BoxWalk::next(double& key) {
  const auto [depth, number] = pop();
  key = depth;
  const BoxHierarchy::Node& node = hierarchy_->nodes()[number];
  for (uint32_t i = 0; i < node.count; ++i) enter(hierarchy_->entries()[node.first + i]);
  return node;
}

// The key is negative where the ray starts within the box. The ways to the near corner and along the
// edge are rounded to single precision, their sum is not.
void BoxWalk::enter(uint32_t number) {
  const BoxHierarchy::Node& node = hierarchy_->nodes()[number];
  if (node.is_infinite) {
    push(kInfiniteKey, number);
    return;
  }
  double enter = -2e10, leave = 2e10;
  for (int i = 0; i < 3; ++i) {
    const float low = node.box.lower[i], high = upper(node.box, i), o = origin_[i];
    if (is_zero_[i]) {
      if (o < low || o > high) return;
      continue;
    }
    const double lower = (low - o) * inverse_[i];
    const double higher = lower + node.box.length[i] * inverse_[i];
    enter = std::max(enter, std::min(lower, higher));
    leave = std::min(leave, std::max(lower, higher));
    if (leave < 1e-10 || enter > leave) return;
  }
  push(enter, number);
}

void BoxWalk::push(double key, uint32_t node) {
  heap_.emplace_back(key, node);
  for (size_t i = heap_.size() - 1; i > 1 && heap_[i].first < heap_[i / 2].first; i /= 2) {
    std::swap(heap_[i], heap_[i / 2]);
  }
}

std::pair<double, uint32_t> BoxWalk::pop() {
  const auto top = heap_[1];
  heap_[1] = heap_.back();
  heap_.pop_back();
  for (size_t i = 1; 2 * i < heap_.size();) {
    size_t child = 2 * i;
    if (child + 1 < heap_.size() && !(heap_[child].first < heap_[child + 1].first)) ++child;
    if (!(heap_[i].first > heap_[child].first)) break;
    std::swap(heap_[i], heap_[child]);
    i = child;
  }
  return top;
}

}  // namespace durer
