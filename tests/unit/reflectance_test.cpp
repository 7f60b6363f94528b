// Laws that the finish's formulas obey whatever their numbers are.
#include "tracer/shading/reflectance.h"

#include <gtest/gtest.h>

#include "tracer/shading/dispersion.h"

namespace durer {
namespace {

FinishNode fresnel_mirror() {
  FinishNode finish;
  finish.reflection_fresnel = true;
  finish.reflection_max = RGB(1.0f);
  return finish;
}

TEST(Reflectance, FresnelIsReciprocal) {
  // From outside at the angle of incidence, from inside at the angle of refraction.
  for (const double ior : {1.1, 1.33, 1.5, 2.4}) {
    for (double outside = 0.05; outside <= 1.0; outside += 0.05) {
      const double sine = std::sqrt(1 - outside * outside) / ior;
      const double inside = std::sqrt(1 - sine * sine);
      const float in = reflectivity(fresnel_mirror(), outside, ior, RGB(1.0f)).color.red;
      const float out = reflectivity(fresnel_mirror(), inside, 1 / ior, RGB(1.0f)).color.red;
      EXPECT_NEAR(in, out, 1e-6f) << ior << ' ' << outside;
    }
  }
}

TEST(Reflectance, FresnelAtNormalIncidenceAndBeyondTheCriticalAngle) {
  const float normal = reflectivity(fresnel_mirror(), 1, 1.5, RGB(1.0f)).color.red;
  EXPECT_NEAR(normal, 0.04f, 1e-6f);
  EXPECT_EQ(reflectivity(fresnel_mirror(), 0.3, 1 / 1.5, RGB(1.0f)).color.red, 1.0f);
}

TEST(Reflectance, FalloffEndsAtItsColors) {
  FinishNode finish;
  finish.reflection_min = {0.1f, 0.2f, 0.3f};
  finish.reflection_max = {0.9f, 0.8f, 0.7f};
  finish.reflection_falloff = 3;
  EXPECT_EQ(reflectivity(finish, 1, 1, RGB(1.0f)).color.green, 0.2f);
  EXPECT_EQ(reflectivity(finish, 0, 1, RGB(1.0f)).color.green, 0.8f);
  EXPECT_NEAR(reflectivity(finish, 0.5, 1, RGB(1.0f)).color.red, 0.1f + 0.8f / 8, 1e-6f);
}

TEST(Reflectance, MetallicTintIsWhiteAtGrazingLight) {
  const RGB pigment{0.8f, 0.4f, 0.1f};
  EXPECT_NEAR(metallic_tint(1, 1, pigment).blue, 0.1f, 1e-3f);
  EXPECT_NEAR(metallic_tint(1, 0, pigment).blue, 1.0f, 1e-3f);
  EXPECT_EQ(metallic_tint(0, 0.5, pigment).blue, 1.0f);
}

TEST(Dispersion, BandsAddUpToWhite) {
  for (const int bands : {2, 3, 7, 20, 100}) {
    const double width = 350.0 / bands;
    RGB sum(0.0f);
    for (int i = 0; i < bands; ++i) sum += band_hue(380 + width * (i + 0.5), width, bands);
    sum *= 1.0f / static_cast<float>(bands);
    EXPECT_NEAR(sum.red, 0.9938f, 1e-3f);
    EXPECT_NEAR(sum.green, 1.0f, 1e-3f);
    EXPECT_NEAR(sum.blue, 0.9962f, 1e-3f);
  }
}

}  // namespace
}  // namespace durer
