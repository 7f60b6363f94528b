#include "tracer/patterns/noise.h"

#include <gtest/gtest.h>

#include "tracer/patterns/pattern.h"

namespace durer {
namespace {

// Figures of spec/textures.md 18, taken from the installed povray.
TEST(Noise, AgreesWithPovray) {
  EXPECT_NEAR(noise({0.1, 0.2, 0.3}, 1), 0.29924290901, 1e-11);
  EXPECT_NEAR(noise({0.1, 0.2, 0.3}, 2), 0.417192032657, 1e-11);
  EXPECT_NEAR(noise({1.1, -2.2, 0.3}, 2), 0.615205057795, 1e-11);
}

// vturbulence(2,.5,6,<1.5,2.5,3.5>) (spec/language.md 8).
TEST(Noise, VectorTurbulenceAgreesWithPovray) {
  const Vec3 t = vector_turbulence({1.5, 2.5, 3.5}, 6, 0.5, 2);
  EXPECT_NEAR(t.x, 0.0695768281, 1e-10);
  EXPECT_NEAR(t.y, -0.0389191375, 1e-10);
  EXPECT_NEAR(t.z, 0.0250328187, 1e-10);
}

TEST(Noise, WavesAndRipplesAgreeWithPovray) {
  PatternNode node;
  node.kind = PatternKind::waves;
  EXPECT_NEAR(Pattern(node, {}).value({0.3, 0.4, 0.5}), 0.732984676941, 1e-10);
  node.kind = PatternKind::ripples;
  EXPECT_NEAR(Pattern(node, {}).value({1.3, -0.4, 0.5}), 0.621921639923, 1e-10);
}

}  // namespace
}  // namespace durer
