// A point of the Mandelbrot set that is seen to be held by an attracting orbit is not iterated; the
// others show that it does not escape.
#include <cmath>
#include <complex>
#include <random>

#include <gtest/gtest.h>

#include "tracer/patterns/pattern.h"

namespace durer {
namespace {

Pattern mandel(int iterations, int interior_type) {
  PatternNode node;
  node.kind = PatternKind::mandel;
  node.fractal.iterations = iterations;
  node.fractal.exterior_type = 0;
  node.fractal.exterior_factor = 0.25;
  node.fractal.interior_type = interior_type;
  node.fractal.interior_factor = interior_type == 0 ? 0.75 : 100;
  return Pattern(node, {});
}

TEST(MandelbrotInterior, IsWhatTheIterationFinds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const int iterations : {10, 100, 3000, 20000}) {
    const Pattern quick = mandel(iterations, 0), iterated = mandel(iterations, 1);
    const int points = 400000 / iterations;
    int interior = 0;
    for (int i = 0; i < points; ++i) {
      // Multipliers about the edge of the two largest parts, and, each seventh, anywhere.
      const std::complex<double> multiplier =
          std::polar(1 + (unit(random) - 0.7) * std::pow(10, -6 * unit(random)),
                     2 * M_PI * unit(random));
      std::complex<double> c = i % 2 ? multiplier / 4.0 - 1.0
                                     : multiplier / 2.0 - multiplier * multiplier / 4.0;
      if (i % 7 == 0) c = {unit(random) * 3 - 2, unit(random) * 3 - 1.5};
      const Vec3 p(c.real(), c.imag(), unit(random));
      // The smallest |z| of an orbit, times 100, is hardly ever a quarter.
      const bool escapes = iterated.value(p) == 0.25;
      ASSERT_EQ(quick.value(p), escapes ? 0.25 : 0.75) << c;
      interior += !escapes;
    }
    EXPECT_GT(interior, points / 3);
    EXPECT_LT(interior, points);
  }
}

}  // namespace
}  // namespace durer
