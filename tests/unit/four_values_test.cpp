// Patterns that work out four points together find, to the last bit, what each point has by itself.
#include <gtest/gtest.h>

#include <random>

#include "tracer/patterns/pattern.h"

namespace durer {
namespace {

PatternNode fractal(PatternKind kind, int exponent, int iterations, int interior, int exterior) {
  PatternNode node;
  node.kind = kind;
  node.fractal.exponent = exponent;
  node.fractal.iterations = iterations;
  node.fractal.interior_type = interior;
  node.fractal.exterior_type = exterior;
  node.fractal.interior_factor = 0.7;
  node.fractal.exterior_factor = 1.3;
  node.fractal.coordinates = {0.3, 0.44};
  return node;
}

void expect_same(const PatternNode& node) {
  const Pattern pattern(node, {});
  const PatternContext context;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 middle(unit(random) * 4 - 2, unit(random) * 4 - 2, unit(random));
    const double reach = i % 2 ? 0.02 : 1;
    Vec3 points[4];
    double together[4];
    for (Vec3& p : points) p = middle + reach * Vec3(unit(random), unit(random), unit(random));
    pattern.values_at_warped(points, context, together);
    for (int k = 0; k < 4; ++k) {
      ASSERT_EQ(together[k], pattern.value_at_warped(points[k], context)) << i << " " << k;
    }
  }
}

TEST(FourValues, OfMandelbrotAndJulia) {
  for (const PatternKind kind : {PatternKind::mandel, PatternKind::julia}) {
    for (const int exponent : {2, 3, 7}) {
      for (const int iterations : {1, 20, 63, 64, 65, 500}) {
        for (int type = 0; type <= 6; ++type) {
          expect_same(fractal(kind, exponent, iterations, type, type));
        }
      }
    }
  }
}

TEST(FourValues, OfMagnets) {
  for (const PatternKind kind : {PatternKind::magnet_mandel, PatternKind::magnet_julia}) {
    for (const int magnet : {1, 2}) {
      for (const int iterations : {20, 100}) {
        PatternNode node = fractal(kind, 2, iterations, 1, 5);
        node.fractal.magnet_type = magnet;
        expect_same(node);
      }
    }
  }
}

TEST(FourValues, OfOthers) {
  for (const PatternKind kind : {PatternKind::granite, PatternKind::crackle, PatternKind::wood}) {
    PatternNode node;
    node.kind = kind;
    node.frequency = 1.5;
    node.wave = WaveKind::scallop;
    expect_same(node);
  }
}

}  // namespace
}  // namespace durer
