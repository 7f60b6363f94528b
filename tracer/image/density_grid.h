// The voxels of a df3 file (spec/textures.md 13).
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "tracer/math/vector.h"

namespace durer {

class DensityGrid {
 public:
  // Reads a df3 file: three 16-bit sizes, then big-endian values of 1, 2 or 4 bytes, x fastest.
  // Throws std::runtime_error with a text for the user if it cannot be read or has a wrong length.
  explicit DensityGrid(const std::string& path);
  // Throws what reading would throw, without reading the values.
  static void check(const std::string& path);

  int size(int axis) const { return sizes_[static_cast<size_t>(axis)]; }
  // 0..1; indices must lie inside.
  double voxel(int x, int y, int z) const;
  // The density at p, 0 outside [0,1). interpolation: 0 none, 1 trilinear, else tricubic.
  double value(const Vec3& p, int interpolation) const;

 private:
  double trilinear(const Vec3& at) const;
  double tricubic(const Vec3& at) const;

  DensityGrid() = default;
  // Size of the values; the file stands behind its header then.
  size_t read_header(std::FILE* file, const std::string& path);

  std::array<int, 3> sizes_{};
  int bytes_per_value_ = 1;
  std::vector<uint8_t> data_;
};

}  // namespace durer
