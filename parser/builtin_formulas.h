// The formulas of the built-in functions (spec/language.md 7, 8): one copy for expressions that are
// computed as they are read (builtins.cpp) and for compiled ones (expression_evaluator.cpp).
#pragma once

#include <cmath>

#include "parser/arithmetic.h"
#include "parser/array.h"
#include "tracer/math/transform.h"

// Functions of one float `p` that are defined everywhere: F(keyword, formula).
#define DURER_FLOAT_FUNCTIONS(F)                                                              \
  F(abs, std::fabs(p)) F(floor, std::floor(p)) F(ceil, std::ceil(p)) F(exp, std::exp(p))      \
  F(sin, std::sin(p)) F(cos, std::cos(p)) F(tan, std::tan(p)) F(sinh, std::sinh(p))           \
  F(cosh, std::cosh(p)) F(tanh, std::tanh(p)) F(atan, std::atan(p)) F(asinh, std::asinh(p))   \
  F(acosh, std::acosh(p)) F(atanh, std::atanh(p)) F(int_, to_int(p)) F(degrees, p / kDegree)  \
  F(radians, p * kDegree)

// And of two, `p` and `q`.
#define DURER_FLOAT_PAIR_FUNCTIONS(F) F(mod, std::fmod(p, q)) F(div, to_int(p / q))

// Folded over a list of floats.
#define DURER_FLOAT_FOLDS(F) F(min, q < p ? q : p) F(max, q > p ? q : p)

namespace durer::builtin {

// Where acos and asin, sqrt, ln and log, atan2, pow are defined.
inline bool has_arc(double a) { return !(a > 1 || a < -1); }
inline bool has_root(double a) { return !(a < 0); }
inline bool has_logarithm(double a) { return !(a <= 0); }
inline bool has_direction(double y, double x) {
  return !(std::fabs(y) <= kEqualityTolerance && std::fabs(x) <= kEqualityTolerance);
}
inline bool has_power(double base, double exponent) { return base != 0 || exponent != 0; }

// Which of select's arguments is the result: 1 to 3, `count` of all arguments being 3 or 4.
inline int selected(double chooser, int count) {
  return chooser < 0 ? 1 : count == 3 || chooser == 0 ? 2 : 3;
}

inline double dimension_size(const ArrayShape& shape, double which) {
  const int32_t dimension = to_int(which);
  return dimension >= 1 && dimension <= shape.dimensions
             ? static_cast<double>(shape.sizes[static_cast<size_t>(dimension - 1)])
             : 0.0;
}

inline double vlength(const Vec3& v) { return std::sqrt(dot(v, v)); }
// Not of the zero vector.
inline Vec3 vnormalize(const Vec3& v) { return v * (1 / vlength(v)); }
inline Vec3 vrotate(const Vec3& v, const Vec3& degrees) {
  return Transform::rotation(degrees).point(v);
}
inline Vec3 vaxis_rotate(const Vec3& v, const Vec3& axis, double degrees) {
  return Transform::axis_rotation(axis / vlength(axis), degrees * kDegree).point(v);
}

}  // namespace durer::builtin
