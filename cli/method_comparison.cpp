#include "cli/method_comparison.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "cli/label.h"
#include "cli/statistics.h"

namespace durer {
namespace {

constexpr int kColumns = 3;
constexpr int kGap = 8;  // pixels between pictures

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f CPU s", seconds);
  return text;
}

void copy(const Framebuffer& from, int left, int top, Framebuffer& to) {
  for (int y = 0; y < from.height(); ++y) {
    for (int x = 0; x < from.width(); ++x) {
      const PixelColor& pixel = from.at(x, y);
      to.at(left + x, top + y) = {pixel.color, 0};
    }
  }
}

}  // namespace

std::vector<Method> compared_methods(int grid) {
  const std::string samples = std::to_string(grid) + " x " + std::to_string(grid);
  return {
      {"Ray casting", "first hit, direct light, shadows", IntegratorKind::raycast,
       Supersampling::none},
      {"Ray tracing", "mirrors and glass, too; 1 sample", IntegratorKind::whitted,
       Supersampling::none},
      {"Grid", samples + " samples in each pixel", IntegratorKind::whitted, Supersampling::grid},
      {"Jitter", samples + " samples, moved at random", IntegratorKind::whitted,
       Supersampling::jitter},
      {"Adaptive: neighbours", "more where pixels differ (+AM1)", IntegratorKind::whitted,
       Supersampling::method1},
      {"Adaptive: corners", "more where corners differ (+AM2)", IntegratorKind::whitted,
       Supersampling::method2},
  };
}

uint64_t MethodResult::rays() const {
  const RayCounts& counts = statistics.rays;
  return counts.primary + counts.reflected + counts.refracted + counts.shadow;
}

Framebuffer method_sheet(const std::vector<MethodResult>& results) {
  const int width = results.front().picture.width(), height = results.front().picture.height();
  const LabelFont font;
  // Name, explanation, cost.
  const double large = std::clamp(width / 14.0, 8.0, 32.0), small = 0.72 * large;
  const int caption = static_cast<int>(large * 1.35 + 2 * small * 1.3);
  const int rows = (static_cast<int>(results.size()) + kColumns - 1) / kColumns;
  const int columns = std::min(kColumns, static_cast<int>(results.size()));
  Framebuffer sheet(columns * (width + kGap) + kGap, rows * (height + caption + kGap) + kGap);
  std::fill_n(sheet.pixels(), static_cast<size_t>(sheet.width()) * sheet.height(),
              PixelColor{RGB(1.0f), 0});
  for (size_t i = 0; i < results.size(); ++i) {
    const MethodResult& result = results[i];
    const int left = kGap + static_cast<int>(i % kColumns) * (width + kGap);
    const int top = kGap + static_cast<int>(i / kColumns) * (height + caption + kGap);
    copy(result.picture, left, top, sheet);
    double baseline = top + height + large;
    font.draw(result.method.name, left, baseline, large, RGB(0.0f), sheet);
    font.draw(result.method.explanation, left, baseline += small * 1.3, small, RGB(0.0f), sheet);
    font.draw(grouped(result.rays()) + " rays, " + seconds_text(result.cpu_seconds), left,
              baseline + small * 1.3, small, RGB(0.0f), sheet);
  }
  return sheet;
}

std::vector<std::string> method_table(const std::vector<MethodResult>& results) {
  std::vector<std::string> lines;
  char line[160];
  std::snprintf(line, sizeof line, "%-22s %12s %14s %14s %10s", "method", "samples", "rays",
                "shadow rays", "CPU s");
  lines.push_back(line);
  for (const MethodResult& result : results) {
    std::snprintf(line, sizeof line, "%-22s %12s %14s %14s %10.2f", result.method.name.c_str(),
                  grouped(result.statistics.samples).c_str(), grouped(result.rays()).c_str(),
                  grouped(result.statistics.rays.shadow).c_str(), result.cpu_seconds);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace durer
