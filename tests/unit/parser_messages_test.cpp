// What the parser says about mistakes: place, caret, chain, hints; and where it stops what never ends.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "parser/parse_scene.h"

namespace durer {
namespace {

namespace fs = std::filesystem;

// A folder of this test with its files, removed at its end.
class ParserMessages : public ::testing::Test, public MessageSink {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / ("durer_messages_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void diagnostic(const Diagnostic& message) override { warnings_ += message.formatted(); }

  void write(const std::string& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  // The error that the text leads to, without the folder; empty: none.
  std::string error_of(const std::string& text) { return error_of_scene("#version 3.7;\n" + text); }
  std::string error_of_scene(const std::string& text) {
    write("scene.pov", text);
    options_.input_file = (folder_ / "scene.pov").string();
    options_.library_paths = {folder_.string()};
    options_.sink = this;
    const ParseResult result = parse_scene(options_);
    return result.failure ? plain(result.failure->formatted()) : "";
  }
  std::string plain(std::string text) const {
    const std::string folder = folder_.string() + "/";
    for (size_t at = 0; (at = text.find(folder, at)) != std::string::npos;) {
      text.erase(at, folder.size());
    }
    return text;
  }

  fs::path folder_;
  ParseOptions options_;
  std::string warnings_;
};

TEST_F(ParserMessages, CaretAndNearestName) {
  EXPECT_EQ(error_of("sphere {\n  0, Radios\n}\n#declare Radius = 2;\n"),
            "scene.pov:3:6: error: 'Radios' is not declared\n  "
            "  0, Radios\n  "
            "     ^\n  hint: did you mean 'radius'?\n");
  EXPECT_NE(error_of("#declare Height = 2;\n#declare B = Heihgt;\n").find("did you mean 'Height'?"),
            std::string::npos);
  EXPECT_NE(error_of("spere { 0, 1 }\n").find("did you mean 'sphere'?"), std::string::npos);
  // What is too far from everything gets no suggestion.
  EXPECT_EQ(error_of("qqqqzzzz { 0, 1 }\n").find("did you mean"), std::string::npos);
}

TEST_F(ParserMessages, MissingSemicolonNamesTheFixBehindTheValue) {
  EXPECT_EQ(error_of("#declare A = 12.5\n#declare B = 3;\n"),
            "scene.pov:2:18: error: expected ';' at the end of this declaration of a number, vector or "
            "colour\n  "
            "#declare A = 12.5\n  "
            "                 ^\n  hint: write ';' behind the value\n");
}

TEST_F(ParserMessages, ChainOfMacrosAndIncludes) {
  write("tree.inc", "#macro Branch(R)\n  sphere { 0, R + \"x\" }\n#end\n#macro Tree()\n  Branch(1)\n#end\n");
  EXPECT_EQ(error_of("#include \"tree.inc\"\nTree()\n"),
            "tree.inc:2:19: error: expected a number, vector or colour, found a string\n  "
            "  sphere { 0, R + \"x\" }\n  "
            "                  ^\n"
            "  in macro Branch, called at tree.inc:5\n"
            "  in macro Tree, called at scene.pov:3\n");
}

TEST_F(ParserMessages, RecursionShowsEachCallOnce) {
  const std::string text = error_of("#macro Again()\n  Again()\n#end\nAgain()\n");
  EXPECT_NE(text.find("called at scene.pov:3, 97 times\n"), std::string::npos) << text;
  EXPECT_NE(text.find("called at scene.pov:5\n"), std::string::npos) << text;
}

TEST_F(ParserMessages, MistakesInDataFiles) {
  write("values.txt", "1,\nword\n");
  const std::string text =
      error_of("#fopen F \"" + (folder_ / "values.txt").string() + "\" read\n#read (F, A, B)\n");
  EXPECT_EQ(text.find("values.txt:2:1: error: expected a number, a vector or a string here\n  word\n  ^\n"
                      "  read at scene.pov:3\n"),
            0u)
      << text;
}

TEST_F(ParserMessages, LaterSyntaxIsNamed) {
  for (const char* text :
       {"#declare (A, B) = (1, 2);\n", "#declare D = dictionary { }\n",
        "#declare D = array mixed [2] { 1, \"a\" }\n", "#macro M(A, optional B)\n#end\nM(1)\n",
        "#declare A = 2 * tau;\n", "lemon { 0, 1, y, 0.5, 0.7 }\n",
        "sphere { 0, 1 finish { fresnel on } }\n",
        "#declare S = spline { akima_spline 0, x, 1, y };\n",
        "sphere { 0, 1 pigment { bozo color_map { blend_mode 1 [0 rgb 1] } } }\n"}) {
    EXPECT_NE(error_of(text).find("POV-Ray 3.8"), std::string::npos) << text;
  }
  EXPECT_NE(error_of("#version 3.8;\n").find("later version"), std::string::npos);
}

TEST_F(ParserMessages, AVersionThatIsNotTheFirstTokenIsNamed) {
  auto warned = [&](const std::string& text) {
    warnings_.clear();
    EXPECT_EQ(error_of_scene(text + "global_settings { assumed_gamma 1 }\n"), "");
    return warnings_.find("before its first #version") != std::string::npos;
  };
  EXPECT_FALSE(warned("// a comment\n# version 3.7;\n#declare A = version;\n#version A;\n"));
  EXPECT_TRUE(warned("#local A = version;\n#version 3.7;\n"));
  EXPECT_TRUE(warned("#debug \"\"\n#version 3.7;\n"));
  EXPECT_TRUE(warned("#if (1) #version 3.7; #end\n"));
}

TEST_F(ParserMessages, FilesAreFoundInSpiteOfCaseAndBackslashes) {
  write("Parts/Wheel.inc", "#declare Wheel = 3;\n");
  EXPECT_EQ(error_of("#include \"parts\\WHEEL.INC\"\n#declare A = Wheel;\n"), "");
  EXPECT_NE(plain(warnings_).find("scene.pov:2:10: warning: there is no file 'parts\\WHEEL.INC'; "
                                  "'Parts/Wheel.inc' is used for it"),
            std::string::npos)
      << warnings_;
}

TEST_F(ParserMessages, MissingFontsAreReplaced) {
  EXPECT_EQ(error_of("text { ttf \"C:\\Fonts\\arialbd.ttf\" \"a\" 1, 0 }\n"), "");
  EXPECT_NE(warnings_.find("the font 'C:\\Fonts\\arialbd.ttf' is not found; '/"), std::string::npos)
      << warnings_;
}

TEST_F(ParserMessages, WhatNeverEndsIsStopped) {
  options_.limits.max_loop_turns = 10'000;
  EXPECT_NE(error_of("#while (1)\n#end\n").find("--max-loop-turns"), std::string::npos);
  options_.limits.max_loop_turns = 1'000'000;
  EXPECT_NE(error_of("#declare A = array[1] { 1 }\n#for (I, 1, 100000)\n"
                     "  #declare A = array[1] { A }\n#end\n")
                .find("which is the limit"),
            std::string::npos);
  EXPECT_NE(error_of("#declare A = array[200000000]\n").find("--max-array-elements"), std::string::npos);
  EXPECT_NE(error_of("#declare S = \"aaaaaaaa\";\n#while (1) #declare S = concat(S, S); #end\n")
                .find("too long"),
            std::string::npos);
}

TEST_F(ParserMessages, MacrosMayBeNestedDeeper) {
  const std::string text = "#macro M(N)\n  #if (N > 0) M(N - 1) #end\n#end\nM(2000)\n";
  EXPECT_NE(error_of(text).find("--max-macro-depth"), std::string::npos);
  options_.limits.max_symbol_tables = 2500;
  options_.limits.max_nesting = 10'000;
  EXPECT_EQ(error_of(text), "");
}

TEST_F(ParserMessages, CopiesAreCounted) {
  const std::string doubling =
      "#declare A = sphere { 0, 1 }\n#for (I, 1, 60)\n"
      "#declare A = union { object { A } object { A } }\n#end\n";
  EXPECT_NE(error_of(doubling).find("scene.pov:4:"), std::string::npos);
  EXPECT_NE(error_of(doubling).find("--max-objects"), std::string::npos);
  for (const char* statement : {"object { A clipped_by { object { A } } }",
                                "light_source { 0, 1 looks_like { union { object { A } object { A } } } }"}) {
    const std::string text = "#declare A = sphere { 0, 1 }\n#for (I, 1, 60)\n#declare A = " +
                             std::string(statement) + "\n#end\n";
    EXPECT_NE(error_of(text).find("--max-objects"), std::string::npos) << statement;
  }
  const std::string trees =
      "#declare T = union { #for (I, 1, 1000) sphere { I, 1 } #end }\n"
      "#declare W = union { #for (I, 1, 1000) object { T translate I } #end }\n";
  options_.limits.max_objects = 1'500'000;
  EXPECT_EQ(error_of(trees + "object { W }\n"), "");
  EXPECT_NE(error_of(trees + "object { W }\nobject { W }\n").find("scene.pov:5:"), std::string::npos);
  options_.limits.max_objects = 999'999;
  EXPECT_NE(error_of(trees).find("1e+06 objects"), std::string::npos);
}

TEST_F(ParserMessages, DeepNestingIsStopped) {
  const auto repeated = [](const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  };
  for (const char* text : {"(", "<", "-", "sin(", "array[1] {", "concat(", "strupr(", "A[", "M(",
                           "F(", "S(", "union {", "sphere { 0, 1 clipped_by {", "function {(", "transform {"}) {
    const std::string error = error_of("#declare A = array[1] { 0 }\n#macro M(X) X #end\n#declare F = function(x) { x }\n"
                                       "#declare S = spline { 0, 1 1, 2 }\n#declare B = " +
                                       repeated(text, 100'000));
    EXPECT_NE(error.find("error: "), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace durer
