// Every internal function against the samples taken from the installed povray
// (tests/data/function_samples.json; spec/functions.md 4).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tracer/functions/compiled_function.h"

namespace durer {
namespace {

TEST(InternalFunctions, AgreeWithTheTable) {
  std::ifstream file(std::string(DURER_SOURCE_DIR) + "/tests/data/function_samples.json");
  const nlohmann::json records = nlohmann::json::parse(file);
  const auto settings = std::make_shared<FieldSettings>();

  std::map<std::string, int> failures;
  int passed = 0, failed = 0;
  for (const auto& record : records) {
    if (record["id"].is_null()) continue;  // functions.inc declares these in the language
    // A fresh identifier for each record: internal(59) keeps its first weights.
    const FunctionHandle f = make_internal_function(record["id"], settings);
    ASSERT_TRUE(f) << record["name"];
    std::vector<double> arguments = record["args"];
    ASSERT_EQ(arguments.size(), static_cast<size_t>(f->parameter_count())) << record["name"];
    const double expected = record["value"], value = f->scalar(arguments.data());
    const double tolerance = 1e-9 * std::max(1.0, std::abs(expected));
    if (std::abs(value - expected) <= tolerance) {
      ++passed;
    } else {
      ++failed;
      if (failures[record["name"]]++ == 0)
        ADD_FAILURE() << record["name"] << record["args"] << " = " << value << ", povray "
                      << expected;
    }
  }
  std::printf("%d passed, %d failed\n", passed, failed);
  EXPECT_GT(passed, 2000);
  EXPECT_EQ(failed, 0);
}

TEST(InternalFunctions, RidgedFractalKeepsItsFirstWeights) {
  const double usual[] = {.3, 1.7, -2.2, 1.5, 2, 6, 1, 2, 2};
  const double other[] = {.3, 1.7, -2.2, 0.1, 2, 6, 1, 2, 2};
  const auto settings = std::make_shared<FieldSettings>();
  const FunctionHandle fresh = make_internal_function(59, settings);
  EXPECT_NEAR(fresh->scalar(usual), 1.285047329796418, 1e-12);
  const FunctionHandle spoiled = make_internal_function(59, settings);
  EXPECT_NEAR(spoiled->scalar(other), 3.960744644760168, 1e-12);
  EXPECT_NEAR(spoiled->scalar(usual), 3.960744644760168, 1e-12);
}

TEST(InternalFunctions, UnknownNumbersGiveNothing) {
  const auto settings = std::make_shared<FieldSettings>();
  EXPECT_FALSE(make_internal_function(79, settings));
  const double origin[3] = {};
  EXPECT_EQ(make_internal_function(77, settings)->scalar(origin), 0);
}

}  // namespace
}  // namespace durer
