// The closed formulas among the internal functions (spec/functions.md 4.2).
#pragma once

namespace durer {

// a: x, y, z, then the extra parameters.
using SurfaceFormula = double (*)(const double* a);

struct InternalSurface {
  int number;
  int extra_parameters;
  SurfaceFormula formula;
};

// Null if the number is not one of them.
const InternalSurface* find_internal_surface(int number);

}  // namespace durer
