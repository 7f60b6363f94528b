// Binned surface area heuristic (Wald 2007, "On fast construction of SAH-based bounding volume
// hierarchies"), eight children to a node. Boxes are sorted in place; each level of the tree reads
// them twice: once into the bins, once to part them.
#include "tracer/intersect/bvh_build.h"

#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/system/pages_ahead.h"

namespace durer {
namespace {

constexpr int kBins = 16;
// Ranges of up to this many are split exactly: bins would cost more than they save.
constexpr uint32_t kExactSize = 12;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Corners in lanes 0 to 2; lane 3 means nothing.
struct Box {
  __m128 low = _mm_set1_ps(kInfinity);
  __m128 high = _mm_set1_ps(-kInfinity);

  void extend(__m128 other_low, __m128 other_high) {
    low = _mm_min_ps(other_low, low);
    high = _mm_max_ps(other_high, high);
  }
  void extend(const Box& b) { extend(b.low, b.high); }
  float half_area() const {
    alignas(16) float d[4];
    _mm_store_ps(d, _mm_sub_ps(high, low));
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

__m128 low_of(const BvhBuildItem& item) { return _mm_load_ps(item.low); }
__m128 high_of(const BvhBuildItem& item) { return _mm_load_ps(item.high); }
float center(const BvhBuildItem& item, int axis) {
  return 0.5f * (item.low[axis] + item.high[axis]);
}

// An item in registers, as rows: what is stored by halves cannot be loaded as a row at once.
struct ItemRows {
  explicit ItemRows(const BvhBuildItem& item)
      : low(_mm_load_ps(item.low)), high(_mm_load_ps(item.high)) {}
  void store(BvhBuildItem& item) const {
    _mm_store_ps(item.low, low);
    _mm_store_ps(item.high, high);
  }

  __m128 low, high;
};

// Items that stay together, their box, and the box of twice their centres.
struct Range {
  uint32_t begin, end;
  Box box, centers;

  uint32_t count() const { return end - begin; }
  void extend(const BvhBuildItem& item) {
    const __m128 low = low_of(item), high = high_of(item);
    box.extend(low, high);
    const __m128 sum = _mm_add_ps(low, high);
    centers.extend(sum, sum);
  }
};

// Where an item's centre lies among the bins.
struct Binning {
  float low, scale;
  int axis;

  float place(const BvhBuildItem& item) const { return (center(item, axis) - low) * scale; }
};

class Builder {
 public:
  Builder(std::vector<BvhBuildItem>& boxes, std::vector<BvhNode>& nodes)
      : boxes_(boxes), nodes_(nodes) {}

  void run() { build_node(range_of(0, static_cast<uint32_t>(boxes_.size()))); }

 private:
  Range range_of(uint32_t begin, uint32_t end) const {
    Range range{begin, end, {}, {}};
    for (uint32_t i = begin; i < end; ++i) range.extend(boxes_[i]);
    return range;
  }

  uint32_t build_node(const Range& whole) {
    const uint32_t index = static_cast<uint32_t>(nodes_.size());
    pages_.before_push(nodes_);
    nodes_.emplace_back();
    Range range[8];
    const int count = divide(whole, range);
    for (int i = 0; i < 8; ++i) {
      uint32_t child = 0;
      if (i < count) {
        child = is_leaf(range[i])
                    ? BvhNode::kLeaf | range[i].begin << 3 | (range[i].count() - 1)
                    : build_node(range[i]);
      }
      BvhNode& node = nodes_[index];
      node.child[i] = child;
      node.used = (1u << count) - 1;
      // Empty slots cannot be entered.
      alignas(16) float low[4], high[4];
      const Box box = i < count ? range[i].box : Box();
      _mm_store_ps(low, box.low);
      _mm_store_ps(high, box.high);
      for (int axis = 0; axis < 3; ++axis) {
        node.low[axis][i] = low[axis];
        node.high[axis][i] = high[axis];
      }
    }
    return index;
  }

  // One item, or two that fill the box around them: far from each other, they are worth a node of their
  // own, which costs less than tests in vain.
  bool is_leaf(const Range& range) const {
    if (range.count() != 2) return range.count() < 2;
    const BvhBuildItem &first = boxes_[range.begin], &second = boxes_[range.begin + 1];
    const Box boxes[2] = {{low_of(first), high_of(first)}, {low_of(second), high_of(second)}};
    return boxes[0].half_area() + boxes[1].half_area() > range.box.half_area();
  }

  // Up to eight ranges of what becomes one node; returns how many.
  int divide(const Range& whole, Range (&range)[8]) {
    int count = 1;
    // Ranges of more than eight become several nodes in any case: open the widest until eight are found.
    range[0] = whole;
    for (; count < 8; ++count) {
      int widest = -1;
      for (int i = 0; i < count; ++i) {
        if (range[i].count() > 8 &&
            (widest < 0 || range[i].box.half_area() > range[widest].box.half_area())) {
          widest = i;
        }
      }
      if (widest < 0) break;
      split(range[widest], range[count]);
    }
    spread_items(range, count);
    return count;
  }

  // Every range of which all items find room beside the others saves a node: the widest to an item first.
  void spread_items(Range (&range)[8], int& count) const {
    for (;;) {
      int best = -1;
      float best_gain = 0;
      for (int i = 0; i < count; ++i) {
        const uint32_t more = range[i].count() - 1;
        if (more == 0 || more > static_cast<uint32_t>(8 - count)) continue;
        const float gain = range[i].box.half_area() / static_cast<float>(more);
        if (best < 0 || gain > best_gain) {
          best = i;
          best_gain = gain;
        }
      }
      if (best < 0) return;
      const uint32_t begin = range[best].begin, end = range[best].end;
      range[best] = range_of(begin, begin + 1);
      for (uint32_t i = begin + 1; i < end; ++i) range[count++] = range_of(i, i + 1);
    }
  }

  // Parts the items where the cost is least; by number where all centres coincide. The first part
  // stays in `left`.
  void split(Range& left, Range& right) {
    const Range whole = left;
    alignas(16) float least[4], extents[4];
    const __m128 half = _mm_set1_ps(0.5f);
    _mm_store_ps(least, _mm_mul_ps(whole.centers.low, half));
    _mm_store_ps(extents, _mm_sub_ps(_mm_mul_ps(whole.centers.high, half),
                                     _mm_mul_ps(whole.centers.low, half)));
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
      if (extents[a] > extents[axis]) axis = a;
    }
    if (whole.count() <= kExactSize) {
      split_exactly(left, right, axis);
      return;
    }
    // A hair less, so that the last centre is in the last bin.
    const Binning binning{least[axis], kBins * (1 - 1e-6f) / extents[axis], axis};
    const int left_bins =
        std::isfinite(binning.scale) ? find_best_split(whole, binning, left, right) : 0;
    if (left_bins == 0) {
      const uint32_t middle = whole.begin + whole.count() / 2;
      left = range_of(whole.begin, middle);
      right = range_of(middle, whole.end);
      return;
    }
    // Every item changes places with the first of the second part, which moves on where it belongs to
    // the first: processors cannot guess where.
    const float border = static_cast<float>(left_bins);
    BvhBuildItem* first = &boxes_[whole.begin];
    BvhBuildItem* const end = first + whole.count();
    for (BvhBuildItem* item = first; item < end; ++item) {
      const ItemRows here(*item), there(*first);
      const bool is_left = binning.place(*item) < border;
      there.store(*item);
      here.store(*first);
      first += is_left;
    }
  }

  // The same of a few: sorted along the axis, every place between two is a candidate.
  void split_exactly(Range& left, Range& right, int axis) {
    const uint32_t begin = left.begin, count = left.count();
    BvhBuildItem* const item = &boxes_[begin];
    for (uint32_t i = 1; i < count; ++i) {
      const ItemRows moved(item[i]);
      const float place = item[i].low[axis] + item[i].high[axis];
      uint32_t j = i;
      for (; j > 0 && item[j - 1].low[axis] + item[j - 1].high[axis] > place; --j) {
        ItemRows(item[j - 1]).store(item[j]);
      }
      moved.store(item[j]);
    }
    Range after[kExactSize];  // the items from each place on
    Range swept{begin + count, begin + count, {}, {}};
    for (uint32_t i = count - 1; i > 0; --i) {
      swept.extend(item[i]);
      swept.begin = begin + i;
      after[i] = swept;
    }
    swept = {begin, begin, {}, {}};
    float best = 0;
    for (uint32_t i = 1; i < count; ++i) {
      swept.extend(item[i - 1]);
      swept.end = begin + i;
      const float cost = swept.box.half_area() * static_cast<float>(i) +
                         after[i].box.half_area() * static_cast<float>(count - i);
      if (i == 1 || cost < best) {
        best = cost;
        left = swept;
        right = after[i];
      }
    }
  }

  // Finds the two parts; returns how many bins are the first's, 0 where all items are in one bin.
  int find_best_split(const Range& range, const Binning& binning, Range& left, Range& right) const {
    Box box[kBins], centers[kBins];
    uint32_t count[kBins] = {};
    for (uint32_t i = range.begin; i < range.end; ++i) {
      const BvhBuildItem& item = boxes_[i];
      const int bin = static_cast<int>(binning.place(item));
      const __m128 low = low_of(item), high = high_of(item), sum = _mm_add_ps(low, high);
      box[bin].extend(low, high);
      centers[bin].extend(sum, sum);
      ++count[bin];
    }
    Range after[kBins];  // the bins from each on
    float right_cost[kBins];
    Range swept{range.end, range.end, {}, {}};
    for (int i = kBins - 1; i > 0; --i) {
      swept.box.extend(box[i]);
      swept.centers.extend(centers[i]);
      swept.begin -= count[i];
      after[i] = swept;
      right_cost[i] = swept.count() ? swept.box.half_area() * static_cast<float>(swept.count()) : 0;
    }
    swept = {range.begin, range.begin, {}, {}};
    float best = kInfinity;
    int left_bins = 0;
    for (int i = 0; i + 1 < kBins; ++i) {
      swept.box.extend(box[i]);
      swept.centers.extend(centers[i]);
      swept.end += count[i];
      if (count[i] == 0 || swept.count() == range.count()) continue;
      const float cost = swept.box.half_area() * static_cast<float>(swept.count()) + right_cost[i + 1];
      if (cost < best) {
        best = cost;
        left_bins = i + 1;
        left = swept;
        right = after[left_bins];
      }
    }
    return left_bins;
  }

  std::vector<BvhBuildItem>& boxes_;
  std::vector<BvhNode>& nodes_;
  PagesAhead pages_;  // of nodes_
};

}  // namespace

void build_bvh_nodes(std::vector<BvhBuildItem>& boxes, std::vector<BvhNode>& nodes,
                     std::vector<uint32_t>& items) {
  Builder(boxes, nodes).run();
  items.resize(boxes.size());
  for (size_t i = 0; i < boxes.size(); ++i) items[i] = boxes[i].item;
}

}  // namespace durer
