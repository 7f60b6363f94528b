// What single operators of the language do with floats (spec/language.md 5): the same wherever an
// expression is evaluated.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "parser/token.h"

namespace durer {

// How far apart numbers may be that count as equal; numbers nearer to zero are false.
inline constexpr double kEqualityTolerance = 1e-10;
inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegree = kPi / 180.0;

inline bool is_true(double number) { return std::fabs(number) > kEqualityTolerance; }

// Not further apart than the tolerance; NaN is the same as everything.
inline bool same_number(double a, double b) { return !(std::fabs(a - b) > kEqualityTolerance); }

inline bool is_comparison(const Token& token) {
  if (token.kind != TokenKind::symbol) return false;
  switch (token.symbol) {
    case Symbol::less:
    case Symbol::less_equal:
    case Symbol::equal:
    case Symbol::not_equal:
    case Symbol::greater_equal:
    case Symbol::greater:
      return true;
    default:
      return false;
  }
}

inline bool holds(Symbol comparison, double a, double b) {
  switch (comparison) {
    case Symbol::less: return a < b;
    case Symbol::less_equal: return a <= b || same_number(a, b);
    case Symbol::equal: return same_number(a, b);
    case Symbol::not_equal: return !same_number(a, b);
    case Symbol::greater_equal: return a >= b || same_number(a, b);
    default: return a > b;
  }
}

// The integer that a 32-bit conversion instruction gives: the least one for what does not fit.
inline int32_t to_int(double number) {
  if (!(number > -2147483649.0 && number < 2147483648.0)) return std::numeric_limits<int32_t>::min();
  return static_cast<int32_t>(number);
}

}  // namespace durer
