// The one interface through which functions, patterns and whoever samples them know each other.
#pragma once

#include "tracer/math/bounds.h"
#include "tracer/math/vector.h"

namespace durer {

// An enclosure of the values a field takes. Infinite where nothing is known.
struct ValueRange {
  double lower;
  double upper;
};

class ScalarField {
 public:
  virtual ~ScalarField() = default;

  virtual double value(const Vec3& p) const = 0;
  // Eight points at once: out[i] = value(points[i]), bit for bit.
  virtual void values(const Vec3 points[8], double out[8]) const {
    for (int i = 0; i < 8; ++i) out[i] = value(points[i]);
  }
  // Bounds all values inside the box. Default: nothing known.
  virtual ValueRange range(const Bounds& box) const;
  // Central differences by default.
  virtual Vec3 gradient(const Vec3& p) const;
};

}  // namespace durer
