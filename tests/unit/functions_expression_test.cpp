// Bodies of function{} read by the parser, against values of the installed povray
// (tests/data/function_expression_samples.json; spec/functions.md 2, 3).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "parser/parser.h"
#include "parser/parser_state.h"
#include "tracer/functions/compiled_function.h"
#include "tracer/scene/function.h"

namespace durer {
namespace {

double number_of(const nlohmann::json& value) {
  if (value.is_number()) return value.get<double>();
  const std::string text = value;
  if (text == "-0") return -0.0;
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(FunctionExpressions, AgreeWithTheTable) {
  std::ifstream file(std::string(DURER_SOURCE_DIR) +
                     "/tests/data/function_expression_samples.json");
  const nlohmann::json records = nlohmann::json::parse(file);

  // All functions in one text, one after the other.
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("durer_expressions_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
       ".pov");
  {
    std::ofstream text(path);
    for (const auto& record : records)
      text << "function(" << record["params"].get<std::string>() << "){"
           << record["expr"].get<std::string>() << "}\n";
  }
  ParseOptions options;
  options.input_file = path.string();
  options.version = 370;
  Parser parser(options);
  parser.state().push_frame(parser.state().load_source(path.string()), 0, nullptr);
  int passed = 0, failed = 0;
  for (const auto& record : records) {
    ASSERT_TRUE(parser.accept(Keyword::function));
    const auto function = parser.state().parse_function(FunctionParameters::xyz, FunctionBodies::any);
    std::vector<double> arguments;
    for (const auto& argument : record["args"]) arguments.push_back(number_of(argument));
    ASSERT_EQ(static_cast<int>(arguments.size()), function->compiled->parameter_count());
    const double value = function->compiled->scalar(arguments.data());
    const double expected = number_of(record["value"]);
    // Printed by povray with 16 digits.
    const bool same = std::isnan(expected)
                          ? std::isnan(value)
                          : value == expected ||
                                std::abs(value - expected) <= 1e-15 * std::abs(expected);
    if (same) {
      ++passed;
    } else {
      ++failed;
      ADD_FAILURE() << record["params"] << " " << record["expr"] << " " << record["args"] << " = "
                    << value << ", povray " << expected;
    }
  }
  std::filesystem::remove(path);
  std::printf("%d passed, %d failed\n", passed, failed);
  EXPECT_EQ(passed, 247);
}

}  // namespace
}  // namespace durer
