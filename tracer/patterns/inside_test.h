// Whether a point is inside something: how the object pattern sees an object.
#pragma once

#include "tracer/math/vector.h"

namespace durer {

class InsideTest {
 public:
  virtual ~InsideTest() = default;
  virtual bool inside(const Vec3& point) const = 0;
};

}  // namespace durer
