// Targa files as POV-Ray reads them: colour maps keep their indices, numbers of 5 bits are multiplied
// by 8, the bit that is left of 16 is alpha, and rows always start at the left.
#include <algorithm>
#include <array>
#include <stdexcept>

#include "tracer/image/byte_file.h"
#include "tracer/image/raster_file.h"

namespace durer {
namespace {

struct Header {
  int comment_length, has_map, kind, map_length, map_bits, bits, descriptor;

  bool is_packed() const { return kind >= 9; }
  bool is_grey() const { return kind % 8 == 3 && map_length == 0; }
  bool is_mapped() const { return map_length > 0; }
  bool starts_at_top() const { return (descriptor & 0x20) != 0; }
};

using Rgba = std::array<uint8_t, 4>;

Rgba color_of(const uint8_t* b, int bits) {
  if (bits >= 24) return {b[2], b[1], b[0], bits == 32 ? b[3] : uint8_t{255}};
  const int word = b[0] | b[1] << 8;
  const auto part = [&](int shift) { return static_cast<uint8_t>((word >> shift & 31) << 3); };
  return {part(10), part(5), part(0),
          bits == 16 && !(word & 0x8000) ? uint8_t{0} : uint8_t{255}};
}

// The stored values of all pixels in the file's order, `size` bytes each.
std::vector<uint8_t> pixel_values(ByteFile& in, size_t count, size_t size, bool packed) {
  std::vector<uint8_t> values;
  values.reserve(count * size);
  if (!packed) {
    const uint8_t* all = in.take(count * size);
    values.assign(all, all + count * size);
  }
  while (values.size() < count * size) {
    const int head = in.byte();
    size_t run = std::min(static_cast<size_t>(head & 127) + 1, count - values.size() / size);
    const bool repeats = (head & 128) != 0;
    const uint8_t* value = in.take(repeats ? size : run * size);
    if (!repeats) values.insert(values.end(), value, value + run * size);
    for (; repeats && run > 0; --run) values.insert(values.end(), value, value + size);
  }
  return values;
}

}  // namespace

RasterFile read_tga(const std::string& path) {
  ByteFile in(path);
  Header head{};
  head.comment_length = in.byte();
  head.has_map = in.byte();
  head.kind = in.byte();
  const int map_start = in.word();
  head.map_length = head.has_map ? in.word() : (in.skip(2), 0);
  head.map_bits = in.byte();
  in.skip(4);
  RasterFile file;
  file.width = in.word();
  file.height = in.word();
  head.bits = in.byte();
  head.descriptor = in.byte();
  const int kind = head.kind % 8;
  const auto is_color = [](int bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; };
  const bool bytes = head.is_mapped() || head.is_grey();
  if (head.kind > 11 || kind < 1 || kind > 3 || map_start != 0 || (kind == 1 && !head.is_mapped()) ||
      (bytes ? head.bits != 8 : !is_color(head.bits)) ||
      (head.is_mapped() && (!is_color(head.map_bits) || head.map_length > 256)))
    throw std::runtime_error("the image '" + path + "' is no readable Targa file");
  check_size(path, file.width, file.height);
  in.skip(static_cast<size_t>(head.comment_length));
  for (int i = 0; i < head.map_length; ++i)
    file.add_to_palette(
        color_of(in.take(static_cast<size_t>(head.map_bits + 7) / 8), head.map_bits));
  file.channels = bytes ? 1 : head.bits == 16 || head.bits == 32 ? 4 : 3;

  const size_t width = static_cast<size_t>(file.width), height = static_cast<size_t>(file.height);
  const size_t size = static_cast<size_t>(head.bits + 7) / 8;
  const size_t channels = static_cast<size_t>(file.channels);
  const auto values = pixel_values(in, width * height, size, head.is_packed());
  file.bytes.resize(width * height * channels);
  for (size_t y = 0; y < height; ++y) {
    const size_t row = head.starts_at_top() ? y : height - 1 - y;
    for (size_t x = 0; x < width; ++x) {
      const uint8_t* from = values.data() + (y * width + x) * size;
      uint8_t* to = file.bytes.data() + (row * width + x) * channels;
      if (bytes) {
        *to = *from;
      } else {
        const Rgba color = color_of(from, head.bits);
        std::copy(color.begin(), color.begin() + file.channels, to);
      }
    }
  }
  return file;
}

}  // namespace durer
