// Which of two coincident surfaces is met: that of the object which POV-Ray tests first. Its
// hierarchy of boxes and the heap that it is walked with decide (spec/geometry.md 2.3, 2.5).
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

  // Whether a ray tests object a before b; neither a nor b need be met. A ray's walk is followed once,
  // as far as its questions ask for, whatever their number.
  bool is_tested_first(uint32_t a, uint32_t b, const Vec3& origin, const Vec3& direction) const;

 private:
  BoxHierarchy hierarchy_;
  uint64_t number_;  // none else of this program has it
};

}  // namespace durer
