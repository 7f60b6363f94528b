#include <gtest/gtest.h>

#include <algorithm>

#include "cli/label.h"
#include "cli/method_comparison.h"

namespace durer {
namespace {

std::vector<MethodResult> results_of_size(int width, int height) {
  std::vector<MethodResult> results;
  for (const Method& method : compared_methods(4)) {
    Framebuffer picture(width, height);
    const float shade = 0.1f * static_cast<float>(results.size() + 1);
    std::fill_n(picture.pixels(), width * height, PixelColor{RGB(shade, 0, 0), 0.5f});
    RenderStatistics statistics;
    statistics.rays.primary = 1000;
    statistics.rays.shadow = 234567;
    results.push_back({method, std::move(picture), statistics, 1.5});
  }
  return results;
}

TEST(MethodComparison, SheetHoldsEveryPictureAndItsCaption) {
  const Framebuffer sheet = method_sheet(results_of_size(100, 60));
  EXPECT_EQ(sheet.width(), 3 * 108 + 8);
  // The second row begins below the first row's captions.
  EXPECT_EQ(sheet.at(8, 8).color, RGB(0.1f, 0, 0));
  EXPECT_EQ(sheet.at(2 * 108 + 107, 67).color, RGB(0.3f, 0, 0));
  EXPECT_EQ(sheet.at(8, 8).transmit, 0);
  const int second_row = (sheet.height() - 8) / 2 + 8;
  EXPECT_EQ(sheet.at(8, second_row).color, RGB(0.4f, 0, 0));
  EXPECT_EQ(sheet.at(0, 0).color, RGB(1.0f));
  // Letters below every picture of the first row, paper between its captions and the next row.
  for (int column = 0; column < 3; ++column) {
    int dark = 0;
    for (int y = 68; y < second_row - 8; ++y) {
      for (int x = 8 + column * 108; x < (column + 1) * 108; ++x) {
        dark += sheet.at(x, y).color.red < 0.5f;
      }
    }
    EXPECT_GT(dark, 60) << column;
  }
}

TEST(MethodComparison, TableNamesRaysAndSeconds) {
  const std::vector<std::string> table = method_table(results_of_size(4, 4));
  ASSERT_EQ(table.size(), 7u);
  EXPECT_NE(table[1].find("Ray casting"), std::string::npos);
  EXPECT_NE(table[1].find("235 567"), std::string::npos);
  EXPECT_NE(table[1].find("1.50"), std::string::npos);
}

TEST(Label, DrawsLettersAboveTheBaselineAndIsClipped) {
  Framebuffer picture(40, 30);
  LabelFont().draw("HHHHHHHHHHHH", 5, 20, 16, RGB(1.0f), picture);
  int above = 0, below = 0, before = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool inked = picture.at(x, y).color.red > 0.5f;
      (y < 20 ? above : below) += inked;
      before += inked && x < 5;
    }
  }
  EXPECT_GT(above, 50);
  EXPECT_EQ(below, 0);
  EXPECT_EQ(before, 0);
}

}  // namespace
}  // namespace durer
