#include "tracer/math/spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace durer {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr SplineInterpolation kKinds[] = {SplineInterpolation::linear,
                                          SplineInterpolation::quadratic,
                                          SplineInterpolation::cubic, SplineInterpolation::natural};

Spline through(std::initializer_list<double> parameters) {
  Spline spline;
  for (const double t : parameters) spline.add(t, {t * t, 1, 2, 3, 4}, 5);
  spline.complete();
  return spline;
}

TEST(Spline, PassesThroughItsKnotsWhateverTheirOrder) {
  const Spline spline = through({3, 0, 2, 1, 4});
  double value[5];
  for (const SplineInterpolation kind : kKinds) {
    for (const double t : {1.0, 2.0, 3.0}) {
      spline.evaluate(t, kind, value);
      EXPECT_NEAR(value[0], t * t, 1e-12);
      EXPECT_NEAR(value[4], 4, 1e-12);
    }
  }
}

TEST(Spline, AtNoNumberIsNoNumber) {
  for (const Spline& spline : {through({0, 1, 2}), through({0, 1, 2, 3})}) {
    for (const SplineInterpolation kind : kKinds) {
      double value[5] = {};
      spline.evaluate(kNan, kind, value);
      for (const double v : value) EXPECT_TRUE(std::isnan(v));
    }
  }
}

// Nothing is said of the values; no knot outside the list is read (the sanitizers watch).
TEST(Spline, TakesKnotsThatAreNoNumbers) {
  for (const Spline& spline : {through({kNan, 1, 2}), through({0, kNan, 2}), through({0, 1, kNan}),
                               through({3, kNan, 0, 2, kNan, 1}), through({kNan, kNan})}) {
    for (const SplineInterpolation kind : kKinds) {
      for (double t = -1; t < 5; t += 0.25) {
        double value[5];
        spline.evaluate(t, kind, value);
        EXPECT_EQ(spline.terms(), 5);
      }
    }
  }
}

}  // namespace
}  // namespace durer
