#include "tracer/shapes/height_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tracer/image/image.h"

namespace durer {
namespace {

// What a pixel's colour means as a height; truncated, never rounded.
class RawHeight {
 public:
  explicit RawHeight(const Image& image)
      : image_(image),
        is_pair_of_bytes_(image.raster().bits != 16 && image.raster().channels >= 3),
        is_grey_(image.raster().channels < 3) {}

  uint16_t operator()(int x, int y) const {
    if (image_.is_palette()) return static_cast<uint16_t>(image_.index(x, y) * 256);
    const ColorRGBFT c = image_.pixel(x, y);
    if (is_grey_) return stored(static_cast<double>(c.red * 65535.0f));
    // Red is the high byte, green the low one.
    if (is_pair_of_bytes_)
      return stored((static_cast<double>(c.red) * 256 + static_cast<double>(c.green)) * 255);
    return stored(
        static_cast<double>((0.297f * c.red + 0.589f * c.green + 0.114f * c.blue) * 65535.0f));
  }

 private:
  // Floats above 1 and below 0 wrap around.
  static uint16_t stored(double value) {
    constexpr double kLimit = 2147483648.0;
    return std::abs(value) < kLimit ? static_cast<uint16_t>(static_cast<int32_t>(value))
                                    : uint16_t{0};
  }

  const Image& image_;
  bool is_pair_of_bytes_, is_grey_;
};

}  // namespace

HeightGrid::HeightGrid(const ImageSource& source) {
  const Image image(raster_of(source), source, ImageUse::raw, WorkingSpace());
  columns_ = image.width();
  rows_ = image.height();
  const RawHeight raw(image);
  heights_.reserve(static_cast<size_t>(columns_) * static_cast<size_t>(rows_));
  for (int row = rows_; row-- > 0;)
    for (int column = 0; column < columns_; ++column) heights_.push_back(raw(column, row));
  const auto [low, high] = std::minmax_element(heights_.begin(), heights_.end());
  least_ = *low;
  greatest_ = *high;
  build_levels();
}

HeightGrid::Range HeightGrid::cell_range(int column, int row) const {
  const uint16_t* near = heights_.data() +
                         static_cast<size_t>(row) * static_cast<size_t>(columns_) +
                         static_cast<size_t>(column);
  const uint16_t* far = near + columns_;
  return {std::min(std::min(near[0], near[1]), std::min(far[0], far[1])),
          std::max(std::max(near[0], near[1]), std::max(far[0], far[1]))};
}

void HeightGrid::build_levels() {
  int columns = columns_ - 1, rows = rows_ - 1;  // of the level below
  for (int below = 0; columns > 1 || rows > 1; ++below) {
    constexpr int kSide = 1 << kLevelShift;
    Level level{(columns + kSide - 1) / kSide, (rows + kSide - 1) / kSide, {}};
    for (int j = 0; j < level.rows; ++j) {
      for (int i = 0; i < level.columns; ++i) {
        Range joined{65535, 0};
        for (int row = j * kSide; row < std::min(rows, (j + 1) * kSide); ++row) {
          for (int column = i * kSide; column < std::min(columns, (i + 1) * kSide); ++column) {
            const Range part = range(below, column, row);
            joined.low = std::min(joined.low, part.low);
            joined.high = std::max(joined.high, part.high);
          }
        }
        level.ranges.push_back(joined);
      }
    }
    columns = level.columns;
    rows = level.rows;
    levels_.push_back(std::move(level));
  }
}

}  // namespace durer
