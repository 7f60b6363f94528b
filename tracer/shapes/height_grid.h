// The heights of a height_field: whole numbers 0..65535 on a grid, with the least and the greatest
// of every square of 8^level cells, so that rays pass over empty ground in long steps
// (spec/geometry.md 12.14).
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/scene/image_source.h"

namespace durer {

class HeightGrid {
 public:
  static constexpr int kLevelShift = 3;  // a block is 8 x 8 of the level below

  // Throws std::runtime_error with a text for the user.
  explicit HeightGrid(const ImageSource& source);

  int columns() const { return columns_; }  // of vertices, along x
  int rows() const { return rows_; }        // along z; row 0 is the picture's last
  int height(int column, int row) const {
    return heights_[static_cast<size_t>(row) * static_cast<size_t>(columns_) +
                    static_cast<size_t>(column)];
  }
  int least() const { return least_; }
  int greatest() const { return greatest_; }

  struct Range {
    uint16_t low, high;
  };
  // Level 0 are the cells between four vertices; the last level is one block.
  int level_count() const { return static_cast<int>(levels_.size()) + 1; }
  Range range(int level, int column, int row) const {
    if (level == 0) return cell_range(column, row);
    const Level& blocks = levels_[static_cast<size_t>(level - 1)];
    return blocks.ranges[static_cast<size_t>(row) * static_cast<size_t>(blocks.columns) +
                         static_cast<size_t>(column)];
  }

 private:
  struct Level {
    int columns, rows;
    std::vector<Range> ranges;
  };

  Range cell_range(int column, int row) const;
  void build_levels();

  int columns_ = 0, rows_ = 0;
  int least_ = 0, greatest_ = 0;
  std::vector<uint16_t> heights_;
  std::vector<Level> levels_;
};

}  // namespace durer
