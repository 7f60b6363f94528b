// Perturbed normals, slope and aoi against values measured on the installed povray
// (tests/data/normal_samples.json, slope_aoi_samples.json; spec/textures.md 14, 6.5, 6.6).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/unit/pattern_reader.h"
#include "tracer/texture/surface_texture.h"

namespace durer {
namespace {

nlohmann::json read_table(const char* name) {
  std::ifstream file(std::string(DURER_SOURCE_DIR) + "/tests/data/" + name);
  return nlohmann::json::parse(file);
}

// Maps and images need the parser.
bool belongs_here(const std::string& text) {
  for (const char* other : {"map", "normal{", "density", "pigment", "sin("})
    if (text.find(other) != std::string::npos) return false;
  return true;
}

// A flat patch y = a x + b z, its geometric normal (-a, 1, -b).
Vec3 patch_normal(const nlohmann::json& surface) {
  return normalize_or_zero({-surface[0].get<double>(), 1, -surface[1].get<double>()});
}

TEST(Normals, AgreeWithTheTable) {
  const nlohmann::json table = read_table("normal_samples.json");
  int cases = 0, passed = 0, failed = 0;
  for (const auto& one : table["cases"]) {
    const std::string text = one["normal"];
    if (!belongs_here(text)) continue;
    const PatternReader reader(text);
    // The table holds what slope sees: without normalisation, clipped (14.2).
    if (reader.no_bump_scale) continue;
    ++cases;
    NormalNode node;
    node.pattern = reader.node;
    node.bump_size = static_cast<float>(reader.amount);
    node.accuracy = static_cast<float>(reader.accuracy);
    const auto normal = compile_normal(node, {});
    PatternContext context;
    context.has_surface = true;
    context.normal = patch_normal(one["surface"]);
    int wrong = 0;
    for (const auto& sample : one["samples"]) {
      const auto& at = sample[0];
      const Vec3 expected(sample[1][0], sample[1][1], sample[1][2]);
      const Vec3 bent = normal->perturb({at[0], at[1], at[2]}, context, context.normal);
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
  EXPECT_GT(cases, 80);
  EXPECT_EQ(failed, 0);
}

TEST(Patterns, SlopeAndAngleOfIncidenceAgreeWithTheTable) {
  const nlohmann::json table = read_table("slope_aoi_samples.json");
  int index = 0, passed = 0, failed = 0;
  for (const auto& one : table["cases"]) {
    const std::string text = one["pattern"];
    const PatternReader reader(text);
    const Pattern pattern(reader.node, {});
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
