#include "tracer/image/png_writer.h"

#include <png.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace durer {
namespace {

[[noreturn]] void fail(const std::string& path) {
  throw std::runtime_error("cannot write '" + path + "': " + std::strerror(errno));
}

// Values of fewer than 8 (or 16) bits fill the stored ones with their high bits.
uint16_t widen(uint32_t value, int bits, int stored) {
  uint32_t result = value << (stored - bits);
  for (int filled = bits; filled < stored; filled += bits) result |= result >> filled;
  return static_cast<uint16_t>(result & ((1u << stored) - 1));
}

void encode(std::FILE* file, const Framebuffer& picture, const PixelFormat& format) {
  const std::vector<uint16_t> values = quantize(picture, format);
  const int channels = format.channels();
  const int stored = format.bits > 8 || format.greyscale ? 16 : 8;

  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  std::vector<png_byte> row(static_cast<size_t>(picture.width()) * channels * (stored / 8));
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    throw std::runtime_error("libpng could not encode the picture");
  }
  png_init_io(png, file);
  const int color_type = format.greyscale
                             ? (format.alpha ? PNG_COLOR_TYPE_GRAY_ALPHA : PNG_COLOR_TYPE_GRAY)
                             : (format.alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width()),
               static_cast<png_uint_32>(picture.height()), stored, color_type,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (format.file.kind == TransferCurve::Kind::srgb) {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  } else {
    png_set_gAMA(png, info, 1.0 / format.file.gamma);
  }
  // Pictures are small beside the work of tracing them: little effort, few filters.
  png_set_compression_level(png, 3);
  png_write_info(png, info);
  const uint16_t* next = values.data();
  for (int y = 0; y < picture.height(); ++y) {
    png_byte* out = row.data();
    for (int i = 0; i < picture.width() * channels; ++i) {
      const uint16_t value = widen(*next++, format.bits, stored);
      if (stored == 16) *out++ = static_cast<png_byte>(value >> 8);
      *out++ = static_cast<png_byte>(value & 255);
    }
    png_write_row(png, row.data());
  }
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
}

}  // namespace

void write_png(const std::string& path, const Framebuffer& picture, const PixelFormat& format) {
  if (path == "-") {
    encode(stdout, picture, format);
    if (std::fflush(stdout) != 0) fail("standard output");
    return;
  }
  const std::string temporary = path + ".part" + std::to_string(getpid());
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (!file) fail(path);
  try {
    encode(file, picture, format);
  } catch (...) {
    std::fclose(file);
    std::remove(temporary.c_str());
    throw;
  }
  if (std::fclose(file) != 0 || std::rename(temporary.c_str(), path.c_str()) != 0) {
    std::remove(temporary.c_str());
    fail(path);
  }
}

}  // namespace durer
