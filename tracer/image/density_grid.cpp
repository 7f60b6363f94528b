#include "tracer/image/density_grid.h"

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace durer {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

using FilePointer = std::unique_ptr<std::FILE, FileCloser>;

FilePointer open(const std::string& path) {
  FilePointer file(std::fopen(path.c_str(), "rb"));
  if (!file) throw std::runtime_error("cannot open the density file '" + path + "'");
  return file;
}

// POV-Ray steps back from index 0 with an unsigned number: only powers of two wrap to the end.
int before(int index, int size) {
  if (index > 0) return index - 1;
  return static_cast<int>(UINT64_MAX % static_cast<uint64_t>(size));
}

// Hermite blend of four samples in single precision; the sums of coefficients are rounded once
// (measured on povray 3.7).
float cubic(float a, float b, float c, float d, float t) {
  const float slope0 = (c - a) / 2, slope1 = (d - b) / 2;
  const double step = static_cast<double>(b - c);
  const double s0 = static_cast<double>(slope0), s1 = static_cast<double>(slope1);
  const auto e = static_cast<float>(2 * step + s0 + s1);
  const auto g = static_cast<float>(-3 * step - 2 * s0 - s1);
  return ((e * t + g) * t + slope0) * t + b;
}

}  // namespace

size_t DensityGrid::read_header(std::FILE* file, const std::string& path) {
  uint8_t header[6];
  if (std::fread(header, 1, 6, file) != 6)
    throw std::runtime_error("the density file '" + path + "' is shorter than its header");
  size_t count = 1;
  for (size_t axis = 0; axis < 3; ++axis) {
    sizes_[axis] = header[2 * axis] << 8 | header[2 * axis + 1];
    count *= static_cast<size_t>(sizes_[axis]);
  }

  // The bytes of a value follow from the length of the file.
  std::fseek(file, 0, SEEK_END);
  const long end = std::ftell(file);
  const size_t length = end > 6 ? static_cast<size_t>(end) - 6 : 0;
  bytes_per_value_ = 0;
  for (int bytes : {4, 2, 1})
    if (bytes_per_value_ == 0 && length == count * static_cast<size_t>(bytes))
      bytes_per_value_ = bytes;
  if (bytes_per_value_ == 0)
    throw std::runtime_error("the length of the density file '" + path +
                             "' does not fit the sizes in its header");
  std::fseek(file, 6, SEEK_SET);
  return length;
}

DensityGrid::DensityGrid(const std::string& path) {
  const FilePointer file = open(path);
  data_.resize(read_header(file.get(), path));
  if (std::fread(data_.data(), 1, data_.size(), file.get()) != data_.size())
    throw std::runtime_error("cannot read the density file '" + path + "'");
}

void DensityGrid::check(const std::string& path) {
  DensityGrid().read_header(open(path).get(), path);
}

double DensityGrid::voxel(int x, int y, int z) const {
  const size_t index =
      (static_cast<size_t>(z) * static_cast<size_t>(sizes_[1]) + static_cast<size_t>(y)) *
          static_cast<size_t>(sizes_[0]) +
      static_cast<size_t>(x);
  const uint8_t* at = data_.data() + index * static_cast<size_t>(bytes_per_value_);
  switch (bytes_per_value_) {
    case 1: return at[0] / 255.0;
    case 2: return (at[0] << 8 | at[1]) / 65535.0;
    default: {
      const uint32_t value = static_cast<uint32_t>(at[0]) << 24 |
                             static_cast<uint32_t>(at[1]) << 16 |
                             static_cast<uint32_t>(at[2]) << 8 | static_cast<uint32_t>(at[3]);
      return value / 4294967295.0;
    }
  }
}

double DensityGrid::value(const Vec3& p, int interpolation) const {
  if (data_.empty()) return 0;
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] >= 0 && p[axis] < 1)) return 0;
  const Vec3 at(p.x * sizes_[0], p.y * sizes_[1], p.z * sizes_[2]);
  double v;
  switch (interpolation) {
    case 0:
      v = voxel(static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z));
      break;
    case 1: v = trilinear(at); break;
    default: v = tricubic(at); break;
  }
  return v < 0 ? 0 : v;
}

double DensityGrid::trilinear(const Vec3& at) const {
  // Samples lie at the lower corners of the cells; beyond the last one the first follows.
  int low[3], high[3];
  Vec3 f;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<int>(at[axis]);
    high[axis] = (low[axis] + 1) % sizes_[static_cast<size_t>(axis)];
    f[axis] = at[axis] - low[axis];
  }
  const auto along_x = [&](int y, int z) {
    return (1 - f.x) * voxel(low[0], y, z) + f.x * voxel(high[0], y, z);
  };
  const auto along_y = [&](int z) {
    return (1 - f.y) * along_x(low[1], z) + f.y * along_x(high[1], z);
  };
  return (1 - f.z) * along_y(low[2]) + f.z * along_y(high[2]);
}

double DensityGrid::tricubic(const Vec3& at) const {
  int index[3][4];
  float t[3];
  for (int axis = 0; axis < 3; ++axis) {
    const int size = sizes_[static_cast<size_t>(axis)], i = static_cast<int>(at[axis]);
    index[axis][0] = before(i, size);
    for (int k = 1; k < 4; ++k) index[axis][k] = (i + k - 1) % size;
    t[axis] = static_cast<float>(at[axis] - i);
  }
  // z first, then y, then x.
  float plane[4];
  for (int x = 0; x < 4; ++x) {
    float line[4];
    for (int y = 0; y < 4; ++y) {
      float sample[4];
      for (int z = 0; z < 4; ++z)
        sample[z] = static_cast<float>(voxel(index[0][x], index[1][y], index[2][z]));
      line[y] = cubic(sample[0], sample[1], sample[2], sample[3], t[2]);
    }
    plane[x] = cubic(line[0], line[1], line[2], line[3], t[1]);
  }
  return cubic(plane[0], plane[1], plane[2], plane[3], t[0]);
}

}  // namespace durer
