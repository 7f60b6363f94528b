// The progress bar's text and the state file of interrupted renders.
#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "cli/console.h"
#include "cli/progress.h"
#include "cli/state_file.h"
#include "cli/statistics.h"

namespace durer {
namespace {

TEST(CliProgress, BarFitsItsColumns) {
  for (const int columns : {20, 40, 80, 200}) {
    for (const double share : {0.0, 0.3, 1.0}) {
      const std::string bar = progress_bar(share, 100, columns);
      EXPECT_LT(bar.size(), static_cast<size_t>(columns)) << bar;
    }
  }
  EXPECT_EQ(progress_bar(0.5, 2, 60),
            " 50 % [#############              ] 2.0 s, about 2.0 s left");
}

TEST(CliProgress, Durations) {
  EXPECT_EQ(duration_text(0.012), "0.01 s");
  EXPECT_EQ(duration_text(1.25), "1.2 s");
  EXPECT_EQ(duration_text(42.9), "42 s");
  EXPECT_EQ(duration_text(200), "3 min 20 s");
  EXPECT_EQ(duration_text(7500), "2 h 5 min");
}

TEST(CliStateFile, ContinuesWhatWasFinished) {
  const std::string path =
      ::testing::TempDir() + "durer_state_" + std::to_string(getpid()) + ".pov-state";
  const auto block_of = [](const PixelWindow& window) {
    Framebuffer block(window);
    for (int y = window.top; y < window.bottom; ++y) {
      for (int x = window.left; x < window.right; ++x) {
        block.at(x, y).color = RGB(static_cast<float>(8 * y + x));
      }
    }
    return block;
  };
  {
    Framebuffer first(8, 8);
    StateFile state(path, "test");
    EXPECT_FALSE(state.exists());
    EXPECT_EQ(state.load(first), 0);
    EXPECT_TRUE(state.create());
    EXPECT_TRUE(state.add(block_of({0, 0, 4, 4})));
    EXPECT_TRUE(state.add(block_of({4, 4, 8, 8})));
    EXPECT_TRUE(state.exists());
  }
  Framebuffer second(8, 8);
  {
    StateFile state(path, "test");
    EXPECT_EQ(state.load(second), 32);
    EXPECT_TRUE(state.has({0, 0, 4, 4}));
    EXPECT_FALSE(state.has({4, 0, 8, 4}));
    EXPECT_EQ(second.at(3, 3).color.red, 27.0f);
    EXPECT_EQ(second.at(5, 6).color.red, 53.0f);
    EXPECT_EQ(second.at(5, 1).color.red, 0.0f);
  }
  Framebuffer third(8, 8);
  {
    // A block whose end is missing is rendered again, and written where it began.
    std::FILE* file = std::fopen(path.c_str(), "r+b");
    ASSERT_EQ(std::fseek(file, -8, SEEK_END), 0);
    ASSERT_EQ(ftruncate(fileno(file), std::ftell(file)), 0);
    std::fclose(file);
    StateFile state(path, "test");
    EXPECT_EQ(state.load(third), 16);
    EXPECT_FALSE(state.has({4, 4, 8, 8}));
    EXPECT_TRUE(state.add(block_of({4, 4, 8, 8})));
  }
  {
    StateFile state(path, "test");
    EXPECT_EQ(state.load(third), 32);
  }
  StateFile other(path, "another picture");
  EXPECT_FALSE(other.exists());
  EXPECT_EQ(other.load(third), 0);
  other.remove();
  EXPECT_NE(access(path.c_str(), F_OK), 0);
}

TEST(CliStatistics, JsonEscapesNames) {
  RunStatistics run;
  run.scene = "a\"b\\c.pov";
  run.frames.resize(2);
  const std::string json = statistics_json(run);
  EXPECT_NE(json.find("\"a\\\"b\\\\c.pov\""), std::string::npos);
  EXPECT_NE(json.find("\"frames\": [\n"), std::string::npos);
}

}  // namespace
}  // namespace durer
