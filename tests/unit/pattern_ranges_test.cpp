// ScalarField of every pattern: range() holds every value, values() is value() eight times.
#include <cmath>
#include <cstdio>
#include <random>

#include "tests/unit/parsed_text.h"
#include "tracer/patterns/pattern.h"
#include "tracer/texture/surface_texture.h"
#include "tracer/world/pattern_services.h"

namespace durer {
namespace {

const char* const kPatterns[] = {
    "agate", "boxed", "bozo", "bozo noise_generator 1", "bozo noise_generator 3", "brick", "bumps",
    "cells", "checker", "crackle", "crackle metric 1 form <1, 0.5, 0>", "cubic", "cylindrical",
    "dents", "density_file df3 \"d1.df3\"", "density_file df3 \"d2.df3\" interpolate 2",
    "function { x * x * 3 - y }", "gradient x", "gradient <1, -2, 3> frequency 0",
    "gradient y frequency 0.3 phase 0.1", "granite", "hexagon", "hexagon cubic_wave",
    "image_pattern { ppm \"a.ppm\" }", "julia <0.3, 0.5>, 10", "leopard", "magnet 1 mandel 8",
    "mandel 10 exterior 6, 3", "marble", "marble turbulence 0.7", "marble turbulence 2 frequency 0",
    "marble turbulence 1 noise_generator 1 frequency 0 ramp_wave", "object { sphere { 0, 1 } }",
    "onion", "pavement number_of_sides 4 number_of_tiles 5 pattern 3",
    "pigment_pattern { checker rgb 1, rgb 0.3 }", "planar", "planar scale 2 translate y rotate 30*z",
    "quilted", "quilted control0 -1 control1 2", "radial", "radial frequency 0", "ripples",
    "ripples frequency 3", "spherical", "spherical frequency 0 scale 3", "spherical poly_wave 3",
    "spherical turbulence 0.4", "spiral1 3", "spiral2 4 turbulence 0.3", "spotted", "square",
    "tiling 7", "tiling 22", "tiling 26", "triangular", "waves", "waves frequency 0.3", "wood",
    "wood turbulence 0.2 frequency 0 ramp_wave", "wrinkles", "bozo warp { repeat 0.4*x }",
    "gradient x scale 3 cubic_wave", "bozo sine_wave frequency 3", "gradient x scallop_wave",
};

class PatternRanges : public testing::TestWithParam<const char*> {};

TEST_P(PatternRanges, HoldEveryValue) {
  const ParsedText parsed =
      parse_text(std::string("#version 3.7; global_settings { assumed_gamma 1 } plane { y, 0 "
                             "pigment {") + GetParam() + "} }");
  ASSERT_EQ(parsed.error, "");
  const auto texture = resolve_textures(*parsed.scene->objects.at(0)).texture;
  const WorldPatternServices services(TextureSettings{}, parsed.scene->settings);
  const Pattern pattern(texture->pigment->pattern, services.settings().patterns);

  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 60; ++round) {
    // Boxes of all sizes, some around the origin.
    Bounds box;
    const double size = std::pow(10.0, -2 + 3 * unit(random));
    box.min = Vec3(unit(random), unit(random), unit(random)) * 4.0 - Vec3(2) - Vec3(size / 2);
    box.max = box.min + Vec3(unit(random), unit(random), unit(random)) * size;
    const ValueRange range = pattern.range(box);
    ASSERT_TRUE(std::isfinite(range.lower) && std::isfinite(range.upper));
    ASSERT_LE(range.lower, range.upper);
    for (int batch = 0; batch < 8; ++batch) {
      Vec3 points[8];
      double values[8];
      for (Vec3& p : points)
        p = box.min + Vec3(unit(random), unit(random), unit(random)) * box.size();
      pattern.values(points, values);
      for (int i = 0; i < 8; ++i) {
        ASSERT_EQ(values[i], pattern.value(points[i]));
        ASSERT_GE(values[i], range.lower) << points[i].x << " " << points[i].y << " " << points[i].z;
        ASSERT_LE(values[i], range.upper) << points[i].x << " " << points[i].y << " " << points[i].z;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PatternRanges, testing::ValuesIn(kPatterns));

// A small box tells more than the whole space where the pattern is simple.
TEST(PatternRange, IsTightForDistances) {
  PatternNode node;
  node.kind = PatternKind::spherical;
  append_transform(node.warps, Transform::scaling(Vec3(2)));
  const ValueRange range = Pattern(node, {}).range({Vec3(0.9), Vec3(1)});
  EXPECT_LT(range.upper - range.lower, 0.1);
}

}  // namespace
}  // namespace durer
