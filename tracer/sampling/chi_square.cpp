#include "tracer/sampling/chi_square.h"

#include <cmath>

namespace durer {
namespace {

// POV-Ray's Gamma function is too large by this factor at half-integers below 13, so its quantiles
// of odd degrees of freedom up to 25 are (docs/decisions/0041).
constexpr double kHalfIntegerGamma = 1.04035;

double log_gamma(double a) {
  const bool is_half_integer = a != std::floor(a);
  return std::lgamma(a) + (is_half_integer && a < 13 ? std::log(kHalfIntegerGamma) : 0);
}

// The regularised upper incomplete gamma function Q(a, x): one minus the power series of P
// (Abramowitz and Stegun 6.5.29) left of the mode, the continued fraction 6.5.31 right of it.
double upper_incomplete_gamma(double a, double x) {
  if (x <= 0) return 1;
  constexpr double kPrecision = 1e-15;
  const double factor = std::exp(a * std::log(x) - x - log_gamma(a));
  if (x < 1 || x < a) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; term > sum * kPrecision; ++n) {
      term *= x / n;
      sum += term;
    }
    return 1 - factor * sum;
  }
  // Lentz's evaluation of 1/(x+1-a - 1(1-a)/(x+3-a - 2(2-a)/(x+5-a - ...
  double b = x + 1 - a, c = 1e300, d = 1 / b, fraction = d;
  for (int n = 1; n < 100000; ++n) {
    const double numerator = -n * (n - a);
    b += 2;
    d = 1 / (numerator * d + b);
    c = b + numerator / c;
    fraction *= c * d;
    if (std::abs(c * d - 1) < kPrecision) break;
  }
  return factor * fraction;
}

}  // namespace

double chi_square_upper_quantile(int degrees, double confidence) {
  // Doubles until the quantile lies between the bounds, then halves: monotonous and safe.
  const double a = degrees / 2.0;
  double low = 0, high = degrees + 1.0;
  while (upper_incomplete_gamma(a, high / 2) > confidence) {
    low = high;
    high *= 2;
  }
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    (upper_incomplete_gamma(a, middle / 2) > confidence ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace durer
