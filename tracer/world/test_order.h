// Which of two surfaces at the same or nearly the same depth is met. POV-Ray's hierarchy of boxes
// and the heap that it is walked with decide (spec/geometry.md 2.3, 2.5): of equal depths that of
// the object tested first counts, and what lies nearer by a last digit may never be tested.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/math/vector.h"
#include "tracer/intersect/box_walk.h"

namespace durer {

class TestOrder {
 public:
  // Boxes of the objects in the order of their declaration.
  explicit TestOrder(const std::vector<FloatBox>& boxes);

  // Whether a ray that meets object a at depth_a and b at depth_b shows a, if there are only these.
  // A ray's walk is followed once, as far as its questions ask for, whatever their number.
  bool shows_first(uint32_t a, double depth_a, uint32_t b, double depth_b, const Vec3& origin,
                   const Vec3& direction) const;
  // How many objects stand before it in the hierarchy.
  uint32_t rank(uint32_t object) const { return ranks_[object]; }

 private:
  BoxHierarchy hierarchy_;
  std::vector<uint32_t> ranks_;
  uint64_t number_;  // none else of this program has it
};

}  // namespace durer
