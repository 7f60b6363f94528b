// A ray in the space of whoever traces it.
#pragma once

#include "tracer/math/vector.h"

namespace durer {

// The open interval of ray parameters that a search looks at.
struct Interval {
  double min;
  double max;
};

struct Ray {
  Vec3 origin;
  Vec3 direction;  // any length but zero: parameters are in units of this length

  Vec3 at(double t) const { return origin + t * direction; }
};

}  // namespace durer
