// TIFF files through libtiff, as POV-Ray reads them: palettes of bytes keep their indices, all else
// passes through libtiff's own conversion to premultiplied RGBA of 8 bits (decision 0053).
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "tracer/image/raster_file.h"
#include "tracer/system/shared_library.h"

namespace durer {
namespace {

struct Tiff {
  SharedLibrary library{DURER_TIFF_LIBRARY};
  DURER_IMPORT(TIFFOpenOptionsAlloc);
  DURER_IMPORT(TIFFOpenOptionsFree);
  DURER_IMPORT(TIFFOpenOptionsSetErrorHandlerExtR);
  DURER_IMPORT(TIFFOpenOptionsSetWarningHandlerExtR);
  DURER_IMPORT(TIFFOpenExt);
  DURER_IMPORT(TIFFClose);
  DURER_IMPORT(TIFFGetField);
  DURER_IMPORT(TIFFGetFieldDefaulted);
  DURER_IMPORT(TIFFIsTiled);
  DURER_IMPORT(TIFFScanlineSize64);
  DURER_IMPORT(TIFFReadScanline);
  DURER_IMPORT(TIFFRGBAImageOK);
  DURER_IMPORT(TIFFRGBAImageBegin);
  DURER_IMPORT(TIFFRGBAImageGet);
  DURER_IMPORT(TIFFRGBAImageEnd);
};

const Tiff& libtiff() { return loaded<Tiff>(); }

using OpenTiff = std::unique_ptr<TIFF, void (*)(TIFF*)>;

// Keeps the first message for the user; those that follow tell of its consequences.
int keep_message(TIFF*, void* kept, const char*, const char* format, va_list arguments) {
  auto& message = *static_cast<std::string*>(kept);
  if (message.empty()) {
    std::array<char, 512> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    message = text.data();
  }
  return 1;  // nothing goes to stderr
}

int ignore_message(TIFF*, void*, const char*, const char*, va_list) { return 1; }

// `message` outlives the file.
OpenTiff open_tiff(const std::string& path, std::string& message) {
  const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(
      libtiff().TIFFOpenOptionsAlloc(), libtiff().TIFFOpenOptionsFree);
  libtiff().TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, &message);
  libtiff().TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
  return {libtiff().TIFFOpenExt(path.c_str(), "r", options.get()), libtiff().TIFFClose};
}

uint16_t field(TIFF* tiff, uint32_t tag) {
  uint16_t value = 0;
  libtiff().TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

bool has_byte_palette(TIFF* tiff) {
  return field(tiff, TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_PALETTE &&
         field(tiff, TIFFTAG_BITSPERSAMPLE) == 8 && field(tiff, TIFFTAG_SAMPLESPERPIXEL) == 1 &&
         !libtiff().TIFFIsTiled(tiff);
}

bool read_palette(TIFF* tiff, RasterFile& file) {
  const uint16_t* parts[3] = {};
  if (!libtiff().TIFFGetField(tiff, TIFFTAG_COLORMAP, &parts[0], &parts[1], &parts[2]))
    return false;
  file.palette.resize(256);
  // Some writers fill the words with bytes.
  uint16_t greatest = 0;
  for (const uint16_t* part : parts)
    greatest = std::max(greatest, *std::max_element(part, part + file.palette.size()));
  const uint16_t scale = greatest < 256 ? 257 : 1;
  for (size_t i = 0; i < file.palette.size(); ++i) {
    for (size_t c = 0; c < 3; ++c)
      file.palette[i][c] = static_cast<uint16_t>(parts[c][i] * scale);
    file.palette[i][3] = 65535;
  }
  const size_t width = static_cast<size_t>(file.width);
  if (libtiff().TIFFScanlineSize64(tiff) != width) return false;
  file.bytes.resize(width * static_cast<size_t>(file.height));
  for (int y = 0; y < file.height; ++y) {
    uint8_t* row = file.bytes.data() + width * static_cast<size_t>(y);
    if (libtiff().TIFFReadScanline(tiff, row, static_cast<uint32_t>(y), 0) < 0) return false;
  }
  return true;
}

bool read_colors(TIFF* tiff, RasterFile& file, std::string& message) {
  std::array<char, 1024> reason{};
  TIFFRGBAImage image{};
  constexpr int kStopOnError = 1;
  if (!libtiff().TIFFRGBAImageBegin(&image, tiff, kStopOnError, reason.data())) {
    message = reason.data();
    return false;
  }
  image.req_orientation = ORIENTATION_TOPLEFT;
  const bool is_grey = image.photometric == PHOTOMETRIC_MINISBLACK ||
                       image.photometric == PHOTOMETRIC_MINISWHITE;
  file.channels = (is_grey ? 1 : 3) + (image.alpha ? 1 : 0);
  std::vector<uint32_t> pixels(static_cast<size_t>(image.width) * image.height);
  const bool good =
      libtiff().TIFFRGBAImageGet(&image, pixels.data(), image.width, image.height) != 0;
  libtiff().TIFFRGBAImageEnd(&image);
  if (!good) return false;
  file.bytes.reserve(pixels.size() * static_cast<size_t>(file.channels));
  for (const uint32_t pixel : pixels) {
    file.bytes.push_back(static_cast<uint8_t>(TIFFGetR(pixel)));
    if (!is_grey) {
      file.bytes.push_back(static_cast<uint8_t>(TIFFGetG(pixel)));
      file.bytes.push_back(static_cast<uint8_t>(TIFFGetB(pixel)));
    }
    if (file.has_alpha()) file.bytes.push_back(static_cast<uint8_t>(TIFFGetA(pixel)));
  }
  return true;
}

}  // namespace

RasterFile read_tiff(const std::string& path) {
  std::string message;
  OpenTiff tiff = open_tiff(path, message);
  const auto fail = [&] {
    throw std::runtime_error("the image '" + path + "' is no readable TIFF: " +
                             (message.empty() ? "unknown error" : message));
  };
  if (!tiff) fail();
  RasterFile file;
  uint32_t width = 0, height = 0;
  libtiff().TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  libtiff().TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  check_size(path, width, height);
  file.width = static_cast<int>(width);
  file.height = static_cast<int>(height);
  if (has_byte_palette(tiff.get())) {
    if (!read_palette(tiff.get(), file)) fail();
    return file;
  }
  // Numbers that are no integers, and rarer kinds.
  std::array<char, 1024> reason{};
  if (!libtiff().TIFFRGBAImageOK(tiff.get(), reason.data())) {
    tiff.reset();
    return read_with_openimageio(path);
  }
  if (!read_colors(tiff.get(), file, message)) fail();
  return file;
}

}  // namespace durer
