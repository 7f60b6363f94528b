#include <png.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "tracer/image/raster_file.h"

namespace durer {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

void ignore_warning(png_structp, png_const_charp) {}

// What survives a longjmp is reached through this.
struct Reading {
  RasterFile file;
  std::vector<png_bytep> rows;
  std::vector<uint8_t> raw;
  std::string message;
};

[[noreturn]] void keep_message(png_structp png, png_const_charp text) {
  static_cast<Reading*>(png_get_error_ptr(png))->message = text;
  longjmp(png_jmpbuf(png), 1);
}

void read_palette(png_structp png, png_infop info, RasterFile& file) {
  png_colorp colors = nullptr;
  int count = 0;
  png_get_PLTE(png, info, &colors, &count);
  png_bytep alpha = nullptr;
  int transparent = 0;
  png_get_tRNS(png, info, &alpha, &transparent, nullptr);
  for (int i = 0; i < count; ++i) {
    const png_byte opacity = i < transparent ? alpha[i] : png_byte{255};
    file.add_to_palette({colors[i].red, colors[i].green, colors[i].blue, opacity});
  }
}

}  // namespace

RasterFile read_png(const std::string& path) {
  const std::unique_ptr<std::FILE, Close> stream(std::fopen(path.c_str(), "rb"));
  if (!stream) throw std::runtime_error("the image '" + path + "' cannot be opened");
  Reading reading;
  RasterFile& file = reading.file;
  png_structp png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, keep_message, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_read_struct(&png, &info, nullptr);
    throw std::runtime_error("the image '" + path + "' is no readable PNG: " + reading.message);
  }
  png_init_io(png, stream.get());
  png_read_info(png, info);
  file.width = static_cast<int>(png_get_image_width(png, info));
  file.height = static_cast<int>(png_get_image_height(png, info));
  const int color_type = png_get_color_type(png, info);
  const bool is_palette = color_type == PNG_COLOR_TYPE_PALETTE;
  int intent;
  double file_gamma;
  if (png_get_sRGB(png, info, &intent)) {
    file.gamma.kind = FileGamma::Kind::srgb;
  } else if (png_get_gAMA(png, info, &file_gamma) && file_gamma > 0) {
    file.gamma = {FileGamma::Kind::power, 1 / file_gamma};
  }
  if (is_palette) {
    read_palette(png, info, file);
    png_set_packing(png);
  } else if (png_get_bit_depth(png, info) < 8) {
    // A transparent colour of the file is none to POV-Ray, only alpha channels and palettes are.
    png_set_expand_gray_1_2_4_to_8(png);
  }
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  file.channels = png_get_channels(png, info);
  file.bits = png_get_bit_depth(png, info) == 16 ? 16 : 8;
  const size_t stride = png_get_rowbytes(png, info);
  reading.raw.resize(stride * static_cast<size_t>(file.height));
  for (int y = 0; y < file.height; ++y)
    reading.rows.push_back(reading.raw.data() + stride * static_cast<size_t>(y));
  png_read_image(png, reading.rows.data());
  png_destroy_read_struct(&png, &info, nullptr);
  if (file.bits == 8) {
    file.bytes = std::move(reading.raw);
  } else {
    file.words.resize(reading.raw.size() / 2);
    for (size_t i = 0; i < file.words.size(); ++i)
      file.words[i] = static_cast<uint16_t>(reading.raw[2 * i] << 8 | reading.raw[2 * i + 1]);
  }
  return std::move(file);
}

}  // namespace durer
