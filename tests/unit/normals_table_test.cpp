// Perturbed normals, slope and aoi against values measured on the installed povray
// (tests/data/normal_samples.json, slope_aoi_samples.json; spec/textures.md 14, 6.5, 6.6).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/unit/parsed_text.h"
#include "tracer/texture/surface_texture.h"
#include "tracer/world/pattern_services.h"

namespace durer {
namespace {

nlohmann::json read_table(const char* name) {
  std::ifstream file(std::string(DURER_SOURCE_DIR) + "/tests/data/" + name);
  return nlohmann::json::parse(file);
}

// A flat patch y = a x + b z, its geometric normal (-a, 1, -b).
Vec3 patch_normal(const nlohmann::json& surface) {
  return normalize_or_zero({-surface[0].get<double>(), 1, -surface[1].get<double>()});
}

// The texture of the one object of a scene.
TexturePtr parse_texture_text(const std::string& text) {
  const ParsedText parsed = parse_text(
      "#version 3.7; global_settings { assumed_gamma 1 } plane { y, 0 texture {" + text + "} }");
  EXPECT_EQ(parsed.error, "") << text;
  return parsed.scene ? resolve_textures(*parsed.scene->objects.at(0)).texture : nullptr;
}

TEST(Normals, AgreeWithTheTable) {
  const nlohmann::json table = read_table("normal_samples.json");
  const WorldPatternServices services(TextureSettings{}, GlobalSettings{});
  int cases = 0, passed = 0, failed = 0;
  for (const auto& one : table["cases"]) {
    ++cases;
    const std::string text = one["normal"];
    const TexturePtr texture = parse_texture_text("pigment { rgb 1 } normal {" + text + "}");
    ASSERT_TRUE(texture);
    const auto normal = compile_normal(*texture->normal, services.settings());
    const bool clipped = text.find("no_bump_scale") != std::string::npos;
    PatternContext context;
    context.has_surface = true;
    context.normal = patch_normal(one["surface"]);
    int wrong = 0;
    for (const auto& sample : one["samples"]) {
      const auto& at = sample[0];
      const Vec3 expected(sample[1][0], sample[1][1], sample[1][2]);
      Vec3 bent = normal->perturb({at[0], at[1], at[2]}, context, context.normal);
      if (clipped) bent = glm::clamp(bent, Vec3(-1), Vec3(1));
      // asin at 16 bit: poor near 1.
      bool same = true;
      for (int i = 0; i < 3; ++i)
        same = same && std::abs(bent[i] - expected[i]) <=
                           (std::abs(expected[i]) > 0.999 ? 3e-3 : 1e-3);
      if (same) {
        ++passed;
      } else {
        ++failed;
        if (wrong++ == 0)
          ADD_FAILURE() << text << one["surface"] << " at " << at << ": " << bent.x << " " << bent.y
                        << " " << bent.z << ", povray " << sample[1];
      }
    }
  }
  std::printf("%d cases: %d passed, %d failed\n", cases, passed, failed);
  EXPECT_EQ(cases, 138);
  EXPECT_EQ(failed, 0);
}

TEST(Patterns, SlopeAndAngleOfIncidenceAgreeWithTheTable) {
  const nlohmann::json table = read_table("slope_aoi_samples.json");
  int index = 0, passed = 0, failed = 0;
  for (const auto& one : table["cases"]) {
    const std::string text = one["pattern"];
    const TexturePtr texture = parse_texture_text("pigment {" + text + "}");
    ASSERT_TRUE(texture);
    const Pattern pattern(texture->pigment->pattern, {});
    const double a = one["surface"][0], b = one["surface"][1];
    PatternContext context;
    context.has_surface = true;
    context.normal = patch_normal(one["surface"]);
    context.ray_direction = {0, -1, 0};
    int wrong = 0;
    for (const auto& sample : one["samples"]) {
      const double x = sample[0], z = sample[1], expected = sample[2];
      const Vec3 p(x, a * x + b * z, z);
      // For point_at the patches stand in a row.
      context.world_point = p + Vec3(index * 0.822, 0, 0);
      const double value = pattern.value(p, context);
      // 16 bit; 0 and 1 are neighbours on the fold.
      const double difference = std::abs(value - expected);
      if (std::min(difference, 1 - difference) <= 2e-4) {
        ++passed;
      } else {
        ++failed;
        if (wrong++ == 0)
          ADD_FAILURE() << text << one["surface"] << " at " << x << " " << z << ": " << value
                        << ", povray " << expected;
      }
    }
    ++index;
  }
  std::printf("%d cases: %d passed, %d failed\n", index, passed, failed);
  EXPECT_GT(passed, 1000);
  EXPECT_EQ(failed, 0);
}

}  // namespace
}  // namespace durer
