#include "tracer/field/scalar_field.h"

#include <limits>

namespace durer {

ValueRange ScalarField::range(const Bounds&) const {
  const double infinity = std::numeric_limits<double>::infinity();
  return {-infinity, infinity};
}

Vec3 ScalarField::gradient(const Vec3& p) const {
  const double h = 1e-5;
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step(0);
    step[axis] = h;
    result[axis] = (value(p + step) - value(p - step)) / (2 * h);
  }
  return result;
}

}  // namespace durer
