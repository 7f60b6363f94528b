#include "tracer/image/byte_rows.h"

namespace durer {
namespace {

constexpr uint32_t kFileHeader = 14, kInfoHeader = 40;  // bytes

FileBytes header_of(int width, int height, uint32_t channels, uint32_t image_bytes) {
  FileBytes header;
  header.text("BM", 2);
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
  header.zeros(16);  // no resolution, no palette
  return header;
}

}  // namespace

// From the bottom row up, blue first; rows are filled up to multiples of four bytes. Not through
// OpenImageIO, which says a wrong size of the picture and takes long to load.
void encode_bmp(std::FILE* file, const Picture& picture, const PictureOutput& output) {
  BlueFirstRows rows(picture, output.format);
  const size_t used = rows.width() * rows.channels(), length = (used + 3) / 4 * 4;
  header_of(picture.width(), picture.height(), static_cast<uint32_t>(rows.channels()),
            static_cast<uint32_t>(length) * static_cast<uint32_t>(picture.height()))
      .write(file);
  FileBytes bytes;
  for (int y = picture.height(); y-- > 0;) {
    bytes.clear();
    bytes.bytes(rows.read(y).data(), used);
    bytes.zeros(length - used);
    bytes.write(file);
  }
}

}  // namespace durer
