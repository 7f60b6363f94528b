#include <algorithm>
#include <memory>
#include <stdexcept>

#include "tracer/image/float_rows.h"
#include "tracer/image/openimageio_loader.h"
#include "tracer/image/picture_writer.h"

namespace durer {
namespace {

constexpr int kDefaultJpegQuality = 85;

ImageFileLayout layout_of(const Picture& picture, const PictureOutput& output,
                          std::string& compression) {
  ImageFileLayout layout{};
  layout.width = picture.width();
  layout.height = picture.height();
  layout.channels = output.format.channels();
  layout.bits = output.format.bits > 8 ? 16 : 8;
  switch (output.format.file.kind) {
    case TransferCurve::Kind::srgb: layout.gamma = 2.2f; break;
    default: layout.gamma = output.format.file.gamma;
  }
  switch (output.type) {
    case PictureFileType::jpeg: {
      layout.format = "jpg";
      const int quality =
          output.compression >= 2 ? std::min(output.compression, 100) : kDefaultJpegQuality;
      compression = "jpeg:" + std::to_string(quality);
      break;
    }
    case PictureFileType::exr: layout.format = "exr", compression = "zip", layout.half = true; break;
    case PictureFileType::hdr: layout.format = "hdr"; break;
    default: layout.format = "tif", compression = "zip"; break;
  }
  if (output.type == PictureFileType::exr || output.type == PictureFileType::hdr) {
    layout.bits = 32;
    layout.gamma = 1;
  }
  if (!compression.empty()) layout.compression = compression.c_str();
  return layout;
}

class RowFile {
 public:
  RowFile(std::FILE* file, const ImageFileLayout& layout) {
    const char* message = nullptr;
    writer_.reset(open_image_writer()(file, &layout, &message));
    check(writer_ ? nullptr : message);
  }
  void write(int y, const void* row) { check(writer_->write_row(y, row)); }
  void finish() { check(writer_->finish()); }

 private:
  static void check(const char* message) {
    if (message) throw std::runtime_error(message);
  }
  std::unique_ptr<ImageRowWriter> writer_;
};

// convert(y, pixels, row) fills a row of the file.
template <typename Value, typename Convert>
void write_rows(RowFile& file, const Picture& picture, const ImageFileLayout& layout,
                Convert&& convert) {
  std::vector<PixelColor> pixels(static_cast<size_t>(layout.width));
  std::vector<Value> row(static_cast<size_t>(layout.width) *
                         static_cast<size_t>(layout.channels));
  for (int y = 0; y < layout.height; ++y) {
    picture.read(y, 0, layout.width, pixels.data());
    convert(y, pixels.data(), row.data());
    file.write(y, row.data());
  }
}

}  // namespace

void encode_with_openimageio(std::FILE* target, const Picture& picture,
                             const PictureOutput& output) {
  std::string compression;
  const ImageFileLayout layout = layout_of(picture, output, compression);
  RowFile file(target, layout);
  if (output.type == PictureFileType::exr) {
    const LinearRows rows(output.format, layout.width);
    write_rows<float>(file, picture, layout,
                      [&](int, const PixelColor* pixels, float* row) { rows.convert(pixels, row); });
  } else if (output.type == PictureFileType::hdr) {
    RgbeRows rows(output.format, layout.width);
    write_rows<float>(file, picture, layout,
                      [&](int y, const PixelColor* pixels, float* row) {
                        rows.quantize_row(y, pixels, row);
                      });
  } else if (layout.bits == 16) {
    Quantizer rows(output.format, layout.width);
    write_rows<uint16_t>(file, picture, layout,
                         [&](int y, const PixelColor* pixels, uint16_t* row) {
                           rows.quantize_row(y, pixels, row);
                         });
  } else {
    Quantizer rows(output.format, layout.width);
    std::vector<uint16_t> codes(static_cast<size_t>(layout.width) *
                                static_cast<size_t>(layout.channels));
    write_rows<uint8_t>(file, picture, layout,
                        [&](int y, const PixelColor* pixels, uint8_t* row) {
                          rows.quantize_row(y, pixels, codes.data());
                          std::copy(codes.begin(), codes.end(), row);
                        });
  }
  file.finish();
}

}  // namespace durer
