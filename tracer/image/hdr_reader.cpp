// Radiance files: a byte per channel and an exponent for the three. As in POV-Ray, what the header
// says but the size is ignored, the directions of the axes too (measured on povray 3.7).
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "tracer/image/byte_file.h"
#include "tracer/image/raster_file.h"

namespace durer {
namespace {

constexpr size_t kChannels = 4;  // red, green, blue, exponent

// Without the newline.
std::string read_line(ByteFile& in) {
  std::string line;
  for (char c = 0; (c = static_cast<char>(in.byte())) != '\n';) line.push_back(c);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

[[noreturn]] void fail(const std::string& path) {
  throw std::runtime_error("the image '" + path + "' is no readable Radiance HDR file");
}

// A row whose channels stand one after the other, each in runs.
void read_channels(ByteFile& in, const std::string& path, std::vector<uint8_t>& row) {
  const size_t width = row.size() / kChannels;
  for (size_t channel = 0; channel < kChannels; ++channel) {
    for (size_t x = 0; x < width;) {
      const uint8_t code = in.byte();
      const bool is_run = code > 128;
      const size_t count = is_run ? code - 128u : code;
      if (count == 0 || count > width - x) fail(path);
      const uint8_t* from = in.take(is_run ? 1 : count);
      for (size_t i = 0; i < count; ++i)
        row[(x + i) * kChannels + channel] = from[is_run ? 0 : i];
      x += count;
    }
  }
}

// A row of pixels; one of 1, 1, 1 says how often the one before it is repeated, a second one behind
// it counts 256 times as much.
void read_pixels(ByteFile& in, const std::string& path, std::vector<uint8_t>& row) {
  const size_t width = row.size() / kChannels;
  int shift = 0;
  for (size_t x = 0; x < width;) {
    const uint8_t* pixel = in.take(kChannels);
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      std::memcpy(&row[x++ * kChannels], pixel, kChannels);
      shift = 0;
      continue;
    }
    const size_t count = shift < 32 ? static_cast<size_t>(pixel[3]) << shift : width;
    if (x == 0 || count > width - x) fail(path);
    for (size_t i = 0; i < count; ++i, ++x)
      std::memcpy(&row[x * kChannels], &row[(x - 1) * kChannels], kChannels);
    shift += 8;
  }
}

void read_row(ByteFile& in, const std::string& path, std::vector<uint8_t>& row) {
  constexpr size_t kLeast = 8, kMost = 0x7fff;  // widths that may be in channels
  const size_t width = row.size() / kChannels;
  if (width >= kLeast && width <= kMost) {
    const uint8_t* mark = in.take(kChannels);
    if (mark[0] == 2 && mark[1] == 2 && !(mark[2] & 0x80)) {
      if ((static_cast<size_t>(mark[2]) << 8 | mark[3]) != width) fail(path);
      return read_channels(in, path, row);
    }
    in.step_back(kChannels);
  }
  read_pixels(in, path, row);
}

}  // namespace

RasterFile read_hdr(const std::string& path) {
  ByteFile in(path);
  if (in.byte() != '#' || in.byte() != '?') fail(path);
  while (!read_line(in).empty()) {
  }
  RasterFile file;
  if (std::sscanf(read_line(in).c_str(), "%*2s %d %*2s %d", &file.height, &file.width) != 2)
    fail(path);
  check_size(path, file.width, file.height);
  file.bits = 32;
  file.channels = 3;
  const size_t width = static_cast<size_t>(file.width);
  file.floats.reserve(width * static_cast<size_t>(file.height) * 3);
  std::vector<uint8_t> row(width * kChannels);
  for (int y = 0; y < file.height; ++y) {
    read_row(in, path, row);
    for (size_t x = 0; x < width; ++x) {
      const uint8_t* pixel = &row[x * kChannels];
      // Each byte stands for the middle of its step (spec/shading.md 6.3).
      const float step = pixel[3] ? std::ldexp(1.0f, pixel[3] - (128 + 8)) : 0;
      for (int c = 0; c < 3; ++c)
        file.floats.push_back((static_cast<float>(pixel[c]) + 0.5f) * step);
    }
  }
  return file;
}

}  // namespace durer
