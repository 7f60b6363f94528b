// Patterns, waves and warps against values taken from the installed povray
// (tests/data/pattern_samples.json; spec/textures.md 18).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/unit/pattern_reader.h"
#include "tracer/patterns/noise.h"
#include "tracer/patterns/pattern.h"

namespace durer {
namespace {

nlohmann::json read_table(const char* name) {
  std::ifstream file(std::string(DURER_SOURCE_DIR) + "/tests/data/" + name);
  return nlohmann::json::parse(file);
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

// Cases that need images, objects or other pigments are tested with the texture room.
bool belongs_here(const nlohmann::json& one) {
  const std::string mode = one["mode"], text = one["sdl"];
  if (mode != "function" && mode != "gray") return false;
  for (const char* other : {"image", "object", "pigment"})
    if (contains(text, other)) return false;
  return true;
}

TEST(Patterns, AgreeWithTheTable) {
  const nlohmann::json table = read_table("pattern_samples.json");
  int passed = 0, failed = 0, cases = 0;
  for (const auto& one : table["cases"]) {
    if (!belongs_here(one)) continue;
    ++cases;
    const std::string text = one["sdl"];
    const bool single = one["mode"] == "gray";
    // Tricubic densities are single precision inside.
    const double tolerance = single || contains(text, "interpolate 2") ? 2e-6 : 1e-9;
    const PatternReader reader(text);
    const Pattern pattern(reader.node, {});

    const auto& points = table["points"][one["p"].get<std::string>()];
    const std::vector<size_t> edges = one.value("edge", std::vector<size_t>{});
    int wrong = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      if (std::find(edges.begin(), edges.end(), i) != edges.end()) continue;
      const Vec3 p(points[i][0], points[i][1], points[i][2]);
      double value = pattern.value(p);
      if (!reader.list.empty())
        value = reader.list[std::min(static_cast<size_t>(value), reader.list.size() - 1)];
      const auto& wanted = one["val"][i];
      const double expected = wanted.is_number() ? wanted.get<double>() : NAN;
      const bool same = std::isnan(expected) ? std::isnan(value)
                                             : std::abs(value - expected) <= tolerance;
      if (same) {
        ++passed;
      } else {
        ++failed;
        if (wrong++ == 0)
          ADD_FAILURE() << text << " at " << p.x << " " << p.y << " " << p.z << ": " << value
                        << ", povray " << expected;
      }
    }
  }
  std::printf("%d cases: %d passed, %d failed\n", cases, passed, failed);
  EXPECT_GT(cases, 600);
  EXPECT_EQ(failed, 0);
}

// f_noise_generator(x,y,z,g): the noise of each generator.
TEST(Patterns, NoiseAgreesWithTheTable) {
  const nlohmann::json table = read_table("pattern_samples.json");
  int checked = 0;
  for (const auto& one : table["cases"]) {
    if (one["mode"] != "expr") continue;
    const std::string id = one["id"];
    const int generator = contains(id, "g1") ? 1 : contains(id, "g3") ? 3 : 2;
    const auto& points = table["points"][one["p"].get<std::string>()];
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(noise({points[i][0], points[i][1], points[i][2]}, generator),
                  one["val"][i].get<double>(), 1e-10);
      ++checked;
    }
  }
  std::printf("%d passed, 0 failed\n", checked);
  EXPECT_GE(checked, 90);
}

}  // namespace
}  // namespace durer
