// Expressions in loops are compiled after a few turns: they must go on giving what reading them
// does.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/parsed_text.h"

namespace durer {
namespace {

const std::string kHead =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "#declare R = seed(3); #declare A = array[4] {1, 2.5, -3, 4}\n"
    "#declare P = array[2][2] {{x, <1, 2, 3>}, {y*2, <4, -5, 6>}}\n"
    "#declare F = function(a, b) { a*a - b/3 }\n"
    "#declare V = <0.5, -1.5, 2>; #declare C = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;\n";

constexpr int kTurns = 9;

// What each turn says: `text` once in a loop, or written out with a number for I in each turn.
std::vector<std::string> in_a_loop(const std::string& text) {
  const ParsedText parsed =
      parse_text(kHead + "#for (I, 1, " + std::to_string(kTurns) + ") " + text + " #end");
  EXPECT_EQ(parsed.error, "") << text;
  return parsed.debug;
}
std::vector<std::string> written_out(const std::string& text) {
  std::string scene = kHead;
  for (int i = 1; i <= kTurns; ++i)
    scene += "#declare I = " + std::to_string(i) + "; " + text + "\n";
  const ParsedText parsed = parse_text(scene);
  EXPECT_EQ(parsed.error, "") << text;
  return parsed.debug;
}

class RepeatedExpression : public ::testing::TestWithParam<const char*> {};

TEST_P(RepeatedExpression, IsWhatReadingItGives) {
  const std::string text =
      std::string("#declare Now = (") + GetParam() +
      "); #debug concat(vstr(5, <0, 0, 0, 0, 0> + Now, \" \", 0, 15), \"\\n\")";
  const std::vector<std::string> loop = in_a_loop(text);
  ASSERT_EQ(loop.size(), static_cast<size_t>(kTurns));
  EXPECT_EQ(loop, written_out(text));
}

INSTANTIATE_TEST_SUITE_P(
    All, RepeatedExpression,
    ::testing::Values(
        "I*2 + 1", "-I.x*3", "1 - 2 - I/7/2", "V*I + x*2", "(V + I).y", "-(V*I)", "!I + !0",
        "<I, 2*I> + 3", "<1, I, 3> * <I, I, 2>", "<1, 2, 3, 4, I>*0.5", "C*I + V",
        "C.transmit + C.gray", "A[mod(I, 4)]*I", "P[mod(I, 2)][1]*I + P[1][mod(I, 2)].y",
        "F(I, 2) + F(2, I)*I", "I < 5 ? V : x*I", "I > 3 & I != 6 | I = 1", "(I >= 4) + (I <= 7)",
        "V < I*x", "rand(R)*I + rand(R)", "rand(R) + 1/(I - 5)",
        "vnormalize(V*(I - 4)) + vcross(V, <I, 1, 0>)",
        "vrotate(V, <10*I, 20, 5>) + vaxis_rotate(V, <1, I, 0>, 30)", "vlength(V*I) + vdot(V, I)",
        "min(I, 4, 2.5*I) + max(I, 4) + select(I - 4, 1, 2, 3) + select(I - 4, 5, 6)",
        "atan2(I, 2) + pow(I, 0.5) + mod(I, 2.5) + div(I, 2) + sqrt(I) + log(I) + ln(I) + exp(I/3)",
        "asin(I/5) + acos(-I/5)", "int(I*1.7) + floor(-I/2) + ceil(I/2) + abs(4 - I)",
        "degrees(I) + radians(I) + pi*I + clock + yes + off", "dimension_size(P, 1 + mod(I, 2))*I",
        "u*I + v"));

TEST(CompiledExpressions, CrossThePagesOfALongLoop) {
  // Some 1,024 tokens are a page: this body has six of them.
  std::string scene =
      "#version 3.7; global_settings { assumed_gamma 1 }\n#declare S = 0;\n#for (I, 1, 8)\n";
  double expected = 0;
  for (int line = 0; line < 500; ++line) {
    scene += "#declare S = S*0.5 + (I + " + std::to_string(line % 7) + ");\n";
  }
  for (int i = 1; i <= 8; ++i) {
    for (int line = 0; line < 500; ++line) expected = expected * 0.5 + (i + line % 7);
  }
  scene += "#debug concat(str(S, 0, 12), \"\\n\")\n#end\n";
  const ParsedText parsed = parse_text(scene);
  ASSERT_EQ(parsed.error, "");
  ASSERT_EQ(parsed.debug.size(), 8u);
  EXPECT_NEAR(std::stod(parsed.debug.back()), expected, 1e-11);
}

TEST(CompiledExpressions, ErrorsNameTheirPlaceInLateTurns) {
  const ParsedText subscript = parse_text(
      "#version 3.7;\n#declare A = array[6] {1, 2, 3, 4, 5, 6}\n#for (I, 0, 20)\n  #declare B = 1 "
      "+\n"
      "    A[I]*2;\n#end\n");
  EXPECT_NE(subscript.error.find(".pov:5:8: error: subscript 6"), std::string::npos)
      << subscript.error;
  const ParsedText root = parse_text(
      "#version 3.7;\n#for (I, 0, 20)\n  #declare B = 1 + sqrt(\n    9.5 - I) + 2;\n#end\n");
  EXPECT_NE(root.error.find(".pov:4:12: error: sqrt of a negative number"), std::string::npos)
      << root.error;
}

TEST(CompiledExpressions, FollowVariablesThatChangeTheirKind) {
  const ParsedText parsed = parse_text(
      "#version 3.7;\n#for (I, 0, 39)\n"
      "  #if (mod(I, 10) = 0) #declare V = I; #end\n"
      "  #if (mod(I, 10) = 5) #declare V = <I, 1, 2>; #end\n"
      "  #declare W = V*2 + 1;\n  #debug concat(str(W.x, 0, 0), \" \", str((x*0 + W).y, 0, 0), "
      "\"\\n\")\n#end\n");
  ASSERT_EQ(parsed.error, "");
  ASSERT_EQ(parsed.debug.size(), 40u);
  for (int i = 0; i < 40; ++i) {
    const int x = i / 5 * 5 * 2 + 1;
    const int y = i % 10 < 5 ? x : 3;
    EXPECT_EQ(parsed.debug[static_cast<size_t>(i)], std::to_string(x) + " " + std::to_string(y));
  }
}

}  // namespace
}  // namespace durer
