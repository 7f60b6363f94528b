// POV-Ray's hierarchy of boxes and the heap that a ray walks it with (spec/geometry.md 2.5). The order of
// tests shows where surfaces coincide, and where a walk ends before it has seen all hits.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "tracer/intersect/float_box.h"

namespace durer {

class BoxHierarchy {
 public:
  struct Node {
    FloatBox box;
    bool is_infinite = false;
    int64_t element = -1;  // of a leaf: a box's number
    uint32_t first = 0, count = 0;  // in entries()
  };

  explicit BoxHierarchy(const std::vector<FloatBox>& boxes);

  // Leaves first, in the order of the boxes.
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<uint32_t>& entries() const { return entries_; }  // numbers of nodes
  uint32_t root() const { return root_; }

 private:
  void build(uint32_t finite_count);
  bool split(uint32_t first, uint32_t last);
  void bundle(uint32_t first, uint32_t last);

  std::vector<Node> nodes_;
  std::vector<uint32_t> list_;     // while it is built: numbers of nodes
  std::vector<uint32_t> entries_;
  uint32_t root_ = 0;
};

// One ray's way through a hierarchy.
class BoxWalk {
 public:
  void start(const BoxHierarchy& hierarchy, const Vec3& origin, const Vec3& direction);
  bool is_over() const { return heap_.size() <= 1; }
  // The next node, its children put on the heap; `key`: where the ray enters its box.
  const BoxHierarchy::Node& next(double& key);

 private:
  void enter(uint32_t node);
  void push(double key, uint32_t node);
  std::pair<double, uint32_t> pop();

  const BoxHierarchy* hierarchy_ = nullptr;
  float origin_[3], inverse_[3];
  bool is_zero_[3];
  // From place 1 on. Which of two equal keys leaves first is the reference's own affair.
  std::vector<std::pair<double, uint32_t>> heap_;
};

}  // namespace durer
