// The contrast of two samples against its definition (spec/shading.md 5).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tracer/sampling/antialiasing.h"

namespace durer {
namespace {

TEST(SampleContrast, IsTheSumOfDifferencesAfterGamma) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0, 1);
  Scene scene;
  scene.settings.gamma_kind = AssumedGamma::power;
  scene.settings.assumed_gamma = 1;
  for (const double threshold : {0.0, 0.01, 0.1, 0.3, 1.5}) {
    RenderOptions options;
    options.antialias_threshold = threshold;
    options.antialias_gamma = 2.5;
    const SampleContrast contrast(scene, options);
    int differing = 0;
    constexpr int kPairs = 20000;
    for (int i = 0; i < kPairs; ++i) {
      // Also black, negative, very bright, and nearly equal colours.
      const auto any = [&] {
        const float value = uniform(random);
        return i % 7 == 0 ? 20 * value - 2 : i % 5 == 0 ? value * 1e-6f : value * value;
      };
      PixelColor a{{any(), any(), any()}, 0}, b{{any(), any(), any()}, 0};
      if (i % 3 == 0) b.color = a.color * (1 + 0.2f * uniform(random));
      double difference = 0;
      const auto add = [&](float x, float y) {
        difference += std::abs(std::pow(std::max(x, 0.0f), 0.4f) - std::pow(std::max(y, 0.0f), 0.4f));
      };
      add(a.color.red, b.color.red);
      add(a.color.green, b.color.green);
      add(a.color.blue, b.color.blue);
      EXPECT_EQ(contrast.differ(a, b), difference >= threshold) << difference;
      differing += difference >= threshold;
    }
    EXPECT_TRUE(threshold == 0 || (differing > 0 && differing < kPairs)) << threshold;
  }
}

}  // namespace
}  // namespace durer
