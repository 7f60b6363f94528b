// Targa 2.0, plain and run-length encoded, laid out as povray lays it out. Not through OpenImageIO,
// which takes longer to load than small pictures to render.
#include <algorithm>

#include "tracer/image/byte_rows.h"

namespace durer {
namespace {

constexpr uint32_t kHeader = 18;  // bytes
constexpr uint8_t kFromTheTop = 0x20;
constexpr size_t kLongestPacket = 128;
constexpr uint8_t kRun = 0x80;

FileBytes header_of(int width, int height, size_t channels, bool is_packed) {
  FileBytes header;
  header.byte(0);                   // no text
  header.byte(0);                   // no colour map
  header.byte(is_packed ? 10 : 2);  // true colour
  header.zeros(5);                  // of the colour map
  header.zeros(4);                  // origin
  header.word(static_cast<uint32_t>(width));
  header.word(static_cast<uint32_t>(height));
  header.byte(static_cast<uint32_t>(8 * channels));
  header.byte(kFromTheTop | (channels == 4 ? 8 : 0));
  return header;
}

float gamma_of(const TransferCurve& curve) {
  return curve.kind == TransferCurve::Kind::srgb ? 2.2f : curve.gamma;
}

// The extension area, with the gamma that is left to the file by the scene's, and the footer.
FileBytes trailer_of(const PixelFormat& format, uint32_t place) {
  constexpr uint32_t kExtension = 495, kGammaUnit = 6553;
  const float gamma = gamma_of(format.file) / gamma_of(format.working);
  FileBytes trailer;
  trailer.word(kExtension);
  trailer.zeros(424);  // author, comments, time, job
  trailer.text("durer", 41);
  trailer.zeros(11);  // version, key colour, shape of pixels
  trailer.word(static_cast<uint32_t>(std::min(gamma * static_cast<float>(kGammaUnit), 65535.0f)));
  trailer.word(kGammaUnit);
  trailer.zeros(8);                    // no corrections, no small picture
  trailer.long_word(kHeader);          // where povray says that a table of the rows is
  trailer.byte(format.alpha ? 3 : 0);  // what the fourth channel is
  trailer.long_word(place);
  trailer.long_word(0);  // no developer's area
  trailer.text("TRUEVISION-XFILE.", 18);
  return trailer;
}

// Packets do not go on to the next row.
void pack_row(const uint8_t* row, size_t width, size_t channels, FileBytes& packed) {
  const auto are_equal = [&](size_t a, size_t b) {
    return std::equal(row + a * channels, row + (a + 1) * channels, row + b * channels);
  };
  for (size_t x = 0; x < width;) {
    const size_t most = std::min(width - x, kLongestPacket);
    size_t count = 1;
    while (count < most && are_equal(x, x + count)) ++count;
    if (count > 1) {
      packed.byte(static_cast<uint32_t>(kRun | (count - 1)));
      packed.bytes(row + x * channels, channels);
    } else {
      // As far as no two neighbours are equal.
      while (count < most && !(x + count + 1 < width && are_equal(x + count, x + count + 1)))
        ++count;
      // A single pixel at the end of a row is a run, as povray writes it.
      const bool is_last = x + 1 == width;
      packed.byte(is_last ? kRun : static_cast<uint32_t>(count - 1));
      packed.bytes(row + x * channels, count * channels);
    }
    x += count;
  }
}

}  // namespace

void encode_tga(std::FILE* file, const Picture& picture, const PictureOutput& output) {
  const bool is_packed = output.type == PictureFileType::tga_rle;
  BlueFirstRows rows(picture, output.format);
  size_t written = kHeader;
  header_of(picture.width(), picture.height(), rows.channels(), is_packed).write(file);
  FileBytes bytes;
  for (int y = 0; y < picture.height(); ++y) {
    const std::vector<uint8_t>& row = rows.read(y);
    bytes.clear();
    if (is_packed) {
      pack_row(row.data(), rows.width(), rows.channels(), bytes);
    } else {
      bytes.bytes(row.data(), row.size());
    }
    bytes.write(file);
    written += bytes.size();
  }
  trailer_of(output.format, static_cast<uint32_t>(written)).write(file);
}

}  // namespace durer
