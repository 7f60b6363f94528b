#include "tracer/intersect/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/intersect/bvh_kernel.h"

namespace durer {
namespace {

constexpr int kBins = 16;
constexpr uint32_t kLeafSize = 2;
// Relative margin of the boxes: the ray's origin is rounded to single precision.
constexpr double kMargin = 2.5e-7;

const bool kHasV3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi2");

float round_down(double x) {
  const float f = static_cast<float>(x);
  return static_cast<double>(f) > x
             ? std::nextafterf(f, -std::numeric_limits<float>::infinity())
             : f;
}
float round_up(double x) { return -round_down(-x); }

struct Box {
  float low[3], high[3];

  void clear() {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::numeric_limits<float>::infinity();
      high[i] = -std::numeric_limits<float>::infinity();
    }
  }
  void extend(const Box& b) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], b.low[i]);
      high[i] = std::max(high[i], b.high[i]);
    }
  }
  float half_area() const {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  }
};

class Builder {
 public:
  Builder(std::vector<Box> boxes, std::vector<BvhNode>& nodes, std::vector<uint32_t>& items)
      : boxes_(std::move(boxes)), nodes_(nodes), items_(items) {
    items_.resize(boxes_.size());
    for (uint32_t i = 0; i < items_.size(); ++i) items_[i] = i;
  }

  void run() { build_node(0, static_cast<uint32_t>(items_.size())); }

 private:
  struct Range {
    uint32_t begin, end;
    Box box;
    uint32_t count() const { return end - begin; }
  };

  Box box_of(uint32_t begin, uint32_t end) const {
    Box box;
    box.clear();
    for (uint32_t i = begin; i < end; ++i) box.extend(boxes_[items_[i]]);
    return box;
  }

  uint32_t build_node(uint32_t begin, uint32_t end) {
    const uint32_t index = static_cast<uint32_t>(nodes_.size());
    nodes_.emplace_back();
    // Open the widest range until eight are found.
    Range range[8];
    int count = 1;
    range[0] = {begin, end, box_of(begin, end)};
    while (count < 8) {
      int widest = -1;
      float most = -1;
      for (int i = 0; i < count; ++i) {
        if (range[i].count() > kLeafSize && range[i].box.half_area() > most) {
          most = range[i].box.half_area();
          widest = i;
        }
      }
      if (widest < 0) break;
      const uint32_t middle = split(range[widest]);
      const Range whole = range[widest];
      range[widest] = {whole.begin, middle, box_of(whole.begin, middle)};
      range[count++] = {middle, whole.end, box_of(middle, whole.end)};
    }
    for (int i = 0; i < 8; ++i) {
      uint32_t child = 0;
      if (i < count) {
        child = range[i].count() <= kLeafSize
                    ? BvhNode::kLeaf | range[i].begin << 3 | (range[i].count() - 1)
                    : build_node(range[i].begin, range[i].end);
      }
      BvhNode& node = nodes_[index];
      node.child[i] = child;
      node.used = (1u << count) - 1;
      for (int axis = 0; axis < 3; ++axis) {
        // Empty slots cannot be entered.
        const float inf = std::numeric_limits<float>::infinity();
        node.low[axis][i] = i < count ? range[i].box.low[axis] : inf;
        node.high[axis][i] = i < count ? range[i].box.high[axis] : -inf;
      }
    }
    return index;
  }

  // Binned surface area heuristic (Wald 2007); halves by number where all centres coincide.
  uint32_t split(const Range& range) {
    float low[3], high[3];
    for (int a = 0; a < 3; ++a) {
      low[a] = std::numeric_limits<float>::infinity();
      high[a] = -low[a];
    }
    for (uint32_t i = range.begin; i < range.end; ++i) {
      for (int a = 0; a < 3; ++a) {
        const float c = center(items_[i], a);
        low[a] = std::min(low[a], c);
        high[a] = std::max(high[a], c);
      }
    }
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
      if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
    }
    const float extent = high[axis] - low[axis];
    const uint32_t half = range.begin + range.count() / 2;
    if (!(extent > 0)) return half;

    const float scale = kBins / extent;
    const auto bin_of = [&](uint32_t item) {
      const int bin = static_cast<int>((center(item, axis) - low[axis]) * scale);
      return std::clamp(bin, 0, kBins - 1);
    };
    Box bin_box[kBins];
    uint32_t bin_count[kBins] = {};
    for (Box& box : bin_box) box.clear();
    for (uint32_t i = range.begin; i < range.end; ++i) {
      const int bin = bin_of(items_[i]);
      bin_box[bin].extend(boxes_[items_[i]]);
      ++bin_count[bin];
    }
    float right_cost[kBins];
    Box sweep;
    sweep.clear();
    uint32_t swept = 0;
    for (int i = kBins - 1; i > 0; --i) {
      sweep.extend(bin_box[i]);
      swept += bin_count[i];
      right_cost[i] = swept ? sweep.half_area() * static_cast<float>(swept) : 0;
    }
    sweep.clear();
    swept = 0;
    float best = std::numeric_limits<float>::infinity();
    int best_bin = -1;
    for (int i = 0; i + 1 < kBins; ++i) {
      sweep.extend(bin_box[i]);
      swept += bin_count[i];
      if (swept == 0 || swept == range.count()) continue;
      const float cost = sweep.half_area() * static_cast<float>(swept) + right_cost[i + 1];
      if (cost < best) {
        best = cost;
        best_bin = i;
      }
    }
    if (best_bin < 0) return half;
    const auto middle =
        std::stable_partition(items_.begin() + range.begin, items_.begin() + range.end,
                              [&](uint32_t item) { return bin_of(item) <= best_bin; });
    return static_cast<uint32_t>(middle - items_.begin());
  }

  float center(uint32_t item, int axis) const {
    return 0.5f * (boxes_[item].low[axis] + boxes_[item].high[axis]);
  }

  std::vector<Box> boxes_;
  std::vector<BvhNode>& nodes_;
  std::vector<uint32_t>& items_;
};

}  // namespace

void Bvh::build(const std::vector<Bounds>& boxes) {
  nodes_.clear();
  items_.clear();
  bounds_ = Bounds();
  if (boxes.empty()) return;
  for (const Bounds& box : boxes) bounds_.extend(box);
  center_ = bounds_.center();
  // Whatever is computed in single precision from points near the boxes errs by less than this.
  const Vec3 half = 0.5 * bounds_.size();
  const double margin = kMargin * std::max({half.x, half.y, half.z}) + 1e-30;
  reach_ = {bounds_.min - Vec3(4 * margin), bounds_.max + Vec3(4 * margin)};
  std::vector<Box> rounded(boxes.size());
  for (size_t i = 0; i < boxes.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      rounded[i].low[axis] = round_down(boxes[i].min[axis] - center_[axis] - margin);
      rounded[i].high[axis] = round_up(boxes[i].max[axis] - center_[axis] + margin);
    }
  }
  nodes_.reserve(boxes.size() / 4 + 1);
  Builder(std::move(rounded), nodes_, items_).run();
  nodes_.shrink_to_fit();
}

void Bvh::visit_ray(const BvhRay& ray, double t_max, BvhRayVisitor visitor,
                    void* context) const {
  if (nodes_.empty()) return;
  // Clip to the whole in double, and start there: far origins would lose their digits.
  double enter = 0, leave = t_max;
  if (!reach_.contains(ray.origin)) {
    ray.clip(reach_, enter, leave);
    if (!(enter <= leave * (1 + 1e-12))) return;
  }
  BvhRayQuery query;
  query.nodes = nodes_.data();
  query.t_offset = enter;
  query.t_max = t_max;
  query.visitor = visitor;
  query.context = context;
  for (int axis = 0; axis < 3; ++axis) {
    query.origin[axis] =
        static_cast<float>(ray.origin[axis] + enter * ray.direction[axis] - center_[axis]);
    query.inverse[axis] = static_cast<float>(ray.inverse[axis]);
  }
  kHasV3 ? v3_kernel::visit_ray(query) : base_kernel::visit_ray(query);
}

void Bvh::visit_point(const Vec3& point, BvhPointVisitor visitor, void* context) const {
  if (nodes_.empty()) return;
  BvhPointQuery query;
  query.nodes = nodes_.data();
  query.visitor = visitor;
  query.context = context;
  for (int axis = 0; axis < 3; ++axis) {
    query.point[axis] = static_cast<float>(point[axis] - center_[axis]);
  }
  kHasV3 ? v3_kernel::visit_point(query) : base_kernel::visit_point(query);
}

}  // namespace durer
