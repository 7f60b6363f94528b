// BMP files as POV-Ray reads them: palettes keep their indices, the fourth byte of 32 bits is alpha,
// pixels follow upon the palette wherever the header says that they are, and each pixel of a file of
// one bit has index 1. What POV-Ray refuses (16 bits, masks, rows from the top) is read by stb_image.
#include <algorithm>
#include <stdexcept>

#include "tracer/image/byte_file.h"
#include "tracer/image/raster_file.h"

namespace durer {
namespace {

enum class Packing : uint32_t { none, runs_of_bytes, runs_of_nibbles };

// Indices from the bottom row up, in runs.
void unpack(ByteFile& in, bool nibbles, RasterFile& file) {
  const int width = file.width, height = file.height;
  int x = 0, y = 0;
  const auto put = [&](int index) {
    if (x < width && y < height)
      file.bytes[static_cast<size_t>(height - 1 - y) * static_cast<size_t>(width) +
                 static_cast<size_t>(x)] = static_cast<uint8_t>(index);
    ++x;
  };
  const auto put_values = [&](const uint8_t* values, bool repeats, int count) {
    for (int i = 0; i < count; ++i) {
      const uint8_t value = values[repeats ? 0 : nibbles ? i / 2 : i];
      put(!nibbles ? value : i % 2 ? value & 15 : value >> 4);
    }
  };
  while (y < height) {
    const int count = in.byte(), value = in.byte();
    const auto repeated = static_cast<uint8_t>(value);
    if (count > 0) {
      put_values(&repeated, true, count);
    } else if (value == 0) {
      x = 0;
      ++y;
    } else if (value == 1) {
      return;
    } else if (value == 2) {
      x += in.byte();
      y += in.byte();
    } else {
      const int bytes = nibbles ? (value + 1) / 2 : value;
      put_values(in.take(static_cast<size_t>(bytes + bytes % 2)), false, value);
    }
  }
}

}  // namespace

RasterFile read_bmp(const std::string& path) {
  ByteFile in(path);
  if (in.word() != 0x4d42)
    throw std::runtime_error("the image '" + path + "' is no readable BMP file");
  in.skip(12);
  const uint32_t header_size = in.long_word();
  const bool is_short = header_size == 12;
  const auto number = [&] { return is_short ? in.word() : static_cast<int32_t>(in.long_word()); };
  RasterFile file;
  file.width = number();
  file.height = number();
  in.skip(2);
  const int bits = in.word();
  auto packing = Packing::none;
  uint32_t color_count = 0;
  if (!is_short) {
    packing = static_cast<Packing>(in.long_word());
    in.skip(12);
    color_count = in.long_word();
    in.skip(4);
  }
  const bool is_mapped = bits == 1 || bits == 4 || bits == 8;
  const bool is_known =
      packing == Packing::none ? is_mapped || bits == 24 || bits == 32
                               : (packing == Packing::runs_of_bytes && bits == 8) ||
                                     (packing == Packing::runs_of_nibbles && bits == 4);
  if (!is_known || file.height < 0) return read_with_stb(path);
  check_size(path, file.width, file.height);
  if (header_size > 40) in.skip(header_size - 40);

  if (is_mapped) {
    const uint32_t all = 1u << bits;
    for (uint32_t i = 0; i < std::min(color_count ? color_count : all, all); ++i) {
      const uint8_t* c = in.take(is_short ? 3 : 4);
      file.add_to_palette({c[2], c[1], c[0], 255});
    }
  }
  const int channels = file.channels = is_mapped ? 1 : bits / 8;
  const size_t width = static_cast<size_t>(file.width), height = static_cast<size_t>(file.height);
  // What runs leave out has the palette's last colour (measured on povray 3.7).
  const uint8_t unwritten = packing != Packing::none && !file.palette.empty()
                                ? static_cast<uint8_t>(file.palette.size() - 1)
                            : bits == 1 ? 1
                                        : 0;
  file.bytes.resize(width * height * static_cast<size_t>(channels), unwritten);
  if (bits == 1) return file;
  if (packing != Packing::none) {
    unpack(in, packing == Packing::runs_of_nibbles, file);
    return file;
  }
  for (size_t y = height; y-- > 0;) {
    const size_t used = (width * static_cast<size_t>(bits) + 7) / 8;
    const uint8_t* from = in.take(used);
    // Some programs leave out what would fill up the file's last row.
    if (y > 0) in.skip((used + 3) / 4 * 4 - used);
    uint8_t* to = file.bytes.data() + y * width * static_cast<size_t>(channels);
    for (size_t x = 0; x < width; ++x) {
      if (bits == 4) {
        *to++ = x % 2 ? from[x / 2] & 15 : from[x / 2] >> 4;
      } else if (bits == 8) {
        *to++ = from[x];
      } else {
        for (const int c : {2, 1, 0}) *to++ = from[c];
        if (bits == 32) *to++ = from[3];
        from += channels;
      }
    }
  }
  return file;
}

}  // namespace durer
