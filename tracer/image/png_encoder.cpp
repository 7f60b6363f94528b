#include <libdeflate.h>
#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>

#include "tracer/image/picture_writer.h"

namespace durer {
namespace {

// Values of fewer than 8 (or 16) bits fill the stored ones with their high bits.
uint16_t widen(uint32_t value, int bits, int stored) {
  uint32_t result = value << (stored - bits);
  for (int filled = bits; filled < stored; filled += bits) result |= result >> filled;
  return static_cast<uint16_t>(result & ((1u << stored) - 1));
}

// What survives a longjmp is reached through this.
struct Message {
  std::string text;
};

[[noreturn]] void keep_message(png_structp png, png_const_charp text) {
  const int reason = errno;
  static_cast<Message*>(png_get_error_ptr(png))->text = reason ? std::strerror(reason) : text;
  longjmp(png_jmpbuf(png), 1);
}

void ignore_warning(png_structp, png_const_charp) {}

int color_type_of(const PixelFormat& format) {
  if (format.greyscale) return format.alpha ? PNG_COLOR_TYPE_GRAY_ALPHA : PNG_COLOR_TYPE_GRAY;
  return format.alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
}

// The picture's rows as PNG stores them: big-endian, interleaved.
class PngRows {
 public:
  PngRows(const Picture& picture, const PixelFormat& format)
      : picture_(picture),
        bits_(format.bits),
        stored_(format.bits > 8 ? 16 : 8),
        quantizer_(format, picture.width()),
        pixels_(static_cast<size_t>(picture.width())),
        codes_(pixels_.size() * static_cast<size_t>(format.channels())),
        row_(codes_.size() * static_cast<size_t>(stored_ / 8)) {}

  int stored_bits() const { return stored_; }
  size_t bytes() const { return row_.size(); }
  size_t bytes_of_pixel() const { return row_.size() / pixels_.size(); }
  png_bytep row(int y) {
    picture_.read(y, 0, picture_.width(), pixels_.data());
    quantizer_.quantize_row(y, pixels_.data(), codes_.data());
    png_bytep out = row_.data();
    for (const uint16_t code : codes_) {
      const uint16_t value = widen(code, bits_, stored_);
      if (stored_ == 16) *out++ = static_cast<png_byte>(value >> 8);
      *out++ = static_cast<png_byte>(value & 255);
    }
    return row_.data();
  }

 private:
  const Picture& picture_;
  const int bits_, stored_;
  Quantizer quantizer_;
  std::vector<PixelColor> pixels_;
  std::vector<uint16_t> codes_;
  std::vector<png_byte> row_;
};

// Pictures of up to so many bytes are compressed at once, in a third of the time that zlib takes;
// larger ones row by row.
constexpr size_t kMostAtOnce = size_t{8} << 20;

// Not cleared: memory that is not written need not be touched.
struct Bytes {
  Bytes() = default;
  explicit Bytes(size_t count)
      : data(std::make_unique_for_overwrite<png_byte[]>(count)), size(count) {}

  std::unique_ptr<png_byte[]> data;
  size_t size = 0;
};

// All rows, each less the pixel to the left (PNG's filter Sub), as one zlib stream.
Bytes compressed_rows(PngRows& rows, int height, int level) {
  const size_t bytes = rows.bytes(), step = rows.bytes_of_pixel();
  const Bytes filtered((bytes + 1) * static_cast<size_t>(height));
  png_bytep out = filtered.data.get();
  for (int y = 0; y < height; ++y) {
    const png_byte* const row = rows.row(y);
    *out++ = PNG_FILTER_VALUE_SUB;
    std::copy_n(row, step, out);
    for (size_t i = step; i < bytes; ++i) out[i] = static_cast<png_byte>(row[i] - row[i - step]);
    out += bytes;
  }
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(level), &libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  Bytes stream(libdeflate_zlib_compress_bound(compressor.get(), filtered.size));
  stream.size = libdeflate_zlib_compress(compressor.get(), filtered.data.get(), filtered.size,
                                         stream.data.get(), stream.size);
  return stream;
}

}  // namespace

void encode_png(std::FILE* file, const Picture& picture, const PictureOutput& output) {
  const PixelFormat& format = output.format;
  PngRows rows(picture, format);
  const bool level_given = output.compression >= 1 && output.compression <= 9;
  Bytes stream;
  if ((rows.bytes() + 1) * static_cast<size_t>(picture.height()) <= kMostAtOnce) {
    stream = compressed_rows(rows, picture.height(), level_given ? output.compression : 1);
  }
  Message message;
  errno = 0;
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    throw std::runtime_error(message.text);
  }
  png_init_io(png, file);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width()),
               static_cast<png_uint_32>(picture.height()), rows.stored_bits(), color_type_of(format),
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (format.file.kind == TransferCurve::Kind::srgb) {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  } else {
    png_set_gAMA(png, info, 1.0 / static_cast<double>(format.file.gamma));
  }
  const png_byte bits = static_cast<png_byte>(format.bits);
  if (bits < rows.stored_bits()) {
    const png_color_8 significant{bits, bits, bits, bits, bits};
    png_set_sBIT(png, info, &significant);
  }
  // Pictures are small beside the work of tracing them: little effort unless more is asked for. One
  // filter for all rows costs a fifth of trying them all and makes hardly larger files.
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_compression_level(png, level_given ? output.compression : 3);
  png_write_info(png, info);
  if (stream.size > 0) {
    png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), stream.data.get(), stream.size);
    png_write_chunk(png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
  } else {
    for (int y = 0; y < picture.height(); ++y) png_write_row(png, rows.row(y));
    png_write_end(png, nullptr);
  }
  png_destroy_write_struct(&png, &info);
}

}  // namespace durer
