#include "tracer/math/spline.h"

#include <algorithm>
#include <cmath>

namespace durer {
namespace {

// What marks knots as unused in POV-Ray: given as the last so far, such a knot is lost (measured on
// povray 3.7).
constexpr double kUnusedParameter = -1e6;

}  // namespace

void Spline::add(double parameter, const std::array<double, 5>& value, int terms) {
  terms_ = std::max(terms_, terms);

  const auto place = std::lower_bound(
      knots_.begin(), knots_.end(), parameter,
      [](const SplineKnot& knot, double t) { return knot.parameter < t; });
  if (place == knots_.end() || place->parameter != parameter) {
    if (place == knots_.end() && place != knots_.begin() && parameter == kUnusedParameter) return;
    knots_.insert(place, {parameter, value});
  } else {
    // The largest of several is not replaced (spec/language.md 21).
    const bool largest = place + 1 == knots_.end();
    if (!largest || knots_.size() == 1) place->value = value;
  }
  second_derivatives_.clear();
}

void Spline::complete() {
  // Tridiagonal system for the second derivatives, zero at both ends.
  const size_t n = knots_.size();
  second_derivatives_.assign(n, {});
  if (n < 3) return;
  std::vector<double> diagonal(n, 0);
  const auto step = [&](size_t i) { return knots_[i + 1].parameter - knots_[i].parameter; };
  for (size_t c = 0; c < 5; ++c) {
    const auto slope = [&](size_t i) {
      return (knots_[i + 1].value[c] - knots_[i].value[c]) / step(i);
    };
    for (size_t i = 1; i + 1 < n; ++i) {
      diagonal[i] = 2 * (step(i - 1) + step(i));
      double right = 6 * (slope(i) - slope(i - 1));
      if (i > 1) {
        const double factor = step(i - 1) / diagonal[i - 1];
        diagonal[i] -= factor * step(i - 1);
        right -= factor * second_derivatives_[i - 1][c];
      }
      second_derivatives_[i][c] = right;
    }
    for (size_t i = n - 2; i >= 1; --i) {
      const double above = i + 2 < n ? step(i) * second_derivatives_[i + 1][c] : 0;
      second_derivatives_[i][c] = (second_derivatives_[i][c] - above) / diagonal[i];
    }
  }
}

void Spline::evaluate(double t, SplineInterpolation as, double* result) const {
  constexpr size_t width = 5;
  const size_t n = knots_.size();
  const auto copy = [&](const SplineKnot& knot) {
    std::copy_n(knot.value.begin(), width, result);
  };
  if (n == 1) return copy(knots_[0]);
  if (n == 2 && as == SplineInterpolation::cubic) {
    for (size_t c = 0; c < width; ++c) result[c] = (knots_[0].value[c] + knots_[1].value[c]) / 2;
    return;
  }
  if (std::isnan(t)) {
    std::fill_n(result, width, t);
    return;
  }

  if (as == SplineInterpolation::cubic) {
    // Catmull-Rom between the second and the last but one knot, constant outside.
    if (!(t > knots_[1].parameter)) return copy(knots_[1]);
    if (!(t <= knots_[n - 2].parameter)) return copy(knots_[n - 2]);
  } else {
    if (!(t > knots_[0].parameter)) return copy(knots_[0]);
    if (!(t < knots_[n - 1].parameter)) return copy(knots_[n - 1]);
  }

  // The segment [i, i+1] that holds t. (Parameters that are no numbers have no order: whatever the
  // search finds then, the knots that are read exist.)
  const auto above = std::lower_bound(
      knots_.begin(), knots_.end(), t,
      [](const SplineKnot& knot, double value) { return knot.parameter < value; });
  const size_t outer = as == SplineInterpolation::cubic ? 2 : 1;
  const size_t i = std::clamp(static_cast<size_t>(above - knots_.begin()), outer, n - outer) - 1;
  const SplineKnot &left = knots_[i], &right = knots_[i + 1];
  const double length = right.parameter - left.parameter;
  const double d = t - left.parameter;

  if (as == SplineInterpolation::linear || n == 2) {
    const double f = d / length;
    for (size_t c = 0; c < width; ++c)
      result[c] = left.value[c] + f * (right.value[c] - left.value[c]);
    return;
  }
  switch (as) {
    case SplineInterpolation::linear: break;
    case SplineInterpolation::quadratic: {
      // Newton's form of the parabola through three knots.
      const size_t k = i == 0 ? 0 : i - 1;
      const SplineKnot &a = knots_[k], &b = knots_[k + 1], &e = knots_[k + 2];
      for (size_t c = 0; c < width; ++c) {
        const double ab = (b.value[c] - a.value[c]) / (b.parameter - a.parameter);
        const double be = (e.value[c] - b.value[c]) / (e.parameter - b.parameter);
        const double second = (be - ab) / (e.parameter - a.parameter);
        result[c] =
            a.value[c] + (t - a.parameter) * (ab + (t - b.parameter) * second);
      }
      break;
    }
    case SplineInterpolation::natural:
      for (size_t c = 0; c < width; ++c) {
        const double m0 = second_derivatives_[i][c], m1 = second_derivatives_[i + 1][c];
        const double slope = (right.value[c] - left.value[c]) / length;
        result[c] = left.value[c] +
                    d * (slope - length * (m1 + 2 * m0) / 6 +
                         d * (m0 / 2 + d * (m1 - m0) / (6 * length)));
      }
      break;
    case SplineInterpolation::cubic: {
      const SplineKnot &before = knots_[i - 1], &after = knots_[i + 2];
      const double u = d / length, u2 = u * u, u3 = u2 * u;
      for (size_t c = 0; c < width; ++c) {
        const double slope = (right.value[c] - left.value[c]) / length;
        const double d0 = length / 2 *
                          ((left.value[c] - before.value[c]) / (left.parameter - before.parameter) +
                           slope);
        const double d1 = length / 2 *
                          ((after.value[c] - right.value[c]) / (after.parameter - right.parameter) +
                           slope);
        result[c] = left.value[c] * (2 * u3 - 3 * u2 + 1) + right.value[c] * (3 * u2 - 2 * u3) +
                    d0 * (u3 - 2 * u2 + u) + d1 * (u3 - u2);
      }
      break;
    }
  }
}

}  // namespace durer
