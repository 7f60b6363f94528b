#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "tracer/image/picture_writer.h"

namespace durer {
namespace {

constexpr uint32_t kFileHeader = 14, kInfoHeader = 40;  // bytes

// Numbers are little-endian.
class Header {
 public:
  void word(uint32_t value) { put(value, 2); }
  void long_word(uint32_t value) { put(value, 4); }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

 private:
  void put(uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<uint8_t>(value >> 8 * i));
  }
  std::vector<uint8_t> bytes_;
};

Header header_of(int width, int height, uint32_t channels, uint32_t image_bytes) {
  Header header;
  header.word(0x4d42);  // "BM"
  header.long_word(kFileHeader + kInfoHeader + image_bytes);
  header.long_word(0);
  header.long_word(kFileHeader + kInfoHeader);
  header.long_word(kInfoHeader);
  header.long_word(static_cast<uint32_t>(width));
  header.long_word(static_cast<uint32_t>(height));
  header.word(1);  // plane
  header.word(8 * channels);
  header.long_word(0);  // not compressed
  header.long_word(image_bytes);
  for (int i = 0; i < 4; ++i) header.long_word(0);  // no resolution, no palette
  return header;
}

void write(std::FILE* file, const std::vector<uint8_t>& bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size())
    throw std::runtime_error(std::strerror(errno));
}

}  // namespace

// From the bottom row up, blue first; rows are filled up to multiples of four bytes. Not through
// OpenImageIO, which says a wrong size of the picture and takes long to load.
void encode_bmp(std::FILE* file, const Picture& picture, const PictureOutput& output) {
  const size_t width = static_cast<size_t>(picture.width());
  const size_t channels = static_cast<size_t>(output.format.channels());
  Quantizer quantizer(output.format, picture.width());
  std::vector<PixelColor> pixels(width);
  std::vector<uint16_t> codes(width * channels);
  std::vector<uint8_t> row((width * channels + 3) / 4 * 4);
  write(file, header_of(picture.width(), picture.height(), static_cast<uint32_t>(channels),
                        static_cast<uint32_t>(row.size()) *
                            static_cast<uint32_t>(picture.height()))
                  .bytes());
  constexpr std::array<size_t, 4> kOrder{2, 1, 0, 3};
  // Dithering goes in the order of the file.
  for (int y = picture.height(); y-- > 0;) {
    picture.read(y, 0, picture.width(), pixels.data());
    quantizer.quantize_row(y, pixels.data(), codes.data());
    for (size_t x = 0; x < width; ++x)
      for (size_t c = 0; c < channels; ++c)
        row[x * channels + c] = static_cast<uint8_t>(codes[x * channels + kOrder[c]]);
    write(file, row);
  }
}

}  // namespace durer
