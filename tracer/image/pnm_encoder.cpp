#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "tracer/image/picture_writer.h"

namespace durer {

// Raw PPM, or PGM for grey pictures. Not through OpenImageIO, which knows 8 bits only.
void encode_pnm(std::FILE* file, const Picture& picture, const PictureOutput& output) {
  const PixelFormat& format = output.format;
  const size_t width = static_cast<size_t>(picture.width());
  const size_t channels = static_cast<size_t>(format.channels());
  Quantizer quantizer(format, picture.width());
  std::vector<PixelColor> pixels(width);
  std::vector<uint16_t> codes(width * channels);
  std::vector<uint8_t> row;
  std::fprintf(file, "P%d\n%d %d\n%d\n", format.greyscale ? 5 : 6, picture.width(),
               picture.height(), (1 << format.bits) - 1);
  for (int y = 0; y < picture.height(); ++y) {
    picture.read(y, 0, picture.width(), pixels.data());
    quantizer.quantize_row(y, pixels.data(), codes.data());
    row.clear();
    for (const uint16_t code : codes) {
      if (format.bits > 8) row.push_back(static_cast<uint8_t>(code >> 8));
      row.push_back(static_cast<uint8_t>(code & 255));
    }
    if (std::fwrite(row.data(), 1, row.size(), file) != row.size()) {
      throw std::runtime_error(std::strerror(errno));
    }
  }
}

}  // namespace durer
