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

// Where POV-Ray's cells leave the range of its integers.
TEST(Noise, AgreesWithPovrayFarAway) {
  EXPECT_NEAR(noise({2147483647.5, 3, 4}, 2), 0.392234902911, 1e-11);
  EXPECT_NEAR(noise({2147483647.5, 3, 4}, 1), 0.248295, 1e-11);
  EXPECT_EQ(noise({8098.1e8, 2.3e10, 1.7e9}, 2), 0);
  for (const Vec3& p : {Vec3(3e9, 0.3, 0.2), Vec3(-3e9, 0.3, 0.2), Vec3(5e12, 1e13, -7e12)})
    EXPECT_EQ(noise(p, 2), 1) << p.x;
  EXPECT_EQ(noise({1e120, 0.3, 0.2}, 2), 1);
}

// vturbulence(2,.5,6,<1.5,2.5,3.5>) (spec/language.md 8).
TEST(Noise, VectorTurbulenceAgreesWithPovray) {
  const Vec3 t = vector_turbulence({1.5, 2.5, 3.5}, 6, 0.5, 2);
  EXPECT_NEAR(t.x, 0.0695768281, 1e-10);
  EXPECT_NEAR(t.y, -0.0389191375, 1e-10);
  EXPECT_NEAR(t.z, 0.0250328187, 1e-10);
}

TEST(Noise, WithoutZTheOthersStay) {
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p(0.37 * i - 150, 1.91 * i, -0.53 * i);
    const Vec3 all = vector_turbulence(p, 1 + i % 9, 0.6, 2.1);
    EXPECT_EQ(vector_turbulence_xy(p, 1 + i % 9, 0.6, 2.1), Vec2(all.x, all.y));
  }
}

// The value folds at 1.00001, as std::fmod does it.
TEST(Pattern, FoldsToTheLastBit) {
  PatternNode node;
  node.kind = PatternKind::gradient;
  node.gradient = {1, 0, 0};
  node.wave = WaveKind::ramp;
  const auto folded = [&](float frequency, float phase) {
    node.frequency = frequency;
    node.phase = phase;
    return Pattern(node, {}).value({0.75, 0, 0});
  };
  const auto expected = [](float frequency, float phase) {
    const double v =
        std::fmod(0.75 * static_cast<double>(frequency) + static_cast<double>(phase), 1.00001);
    return v < 0 ? v - std::floor(v) : v;
  };
  for (int i = 1; i < 4000; ++i) {
    const float phase = static_cast<float>(i) * 0.37f - 700,
                frequency = static_cast<float>(1 << i % 24);
    EXPECT_EQ(folded(frequency, phase), expected(frequency, phase)) << frequency << ' ' << phase;
    EXPECT_EQ(folded(-frequency, phase), expected(-frequency, phase)) << frequency << ' ' << phase;
  }
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
