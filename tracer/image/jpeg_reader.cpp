#include <cstdio>
// These need FILE.
#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <memory>
#include <stdexcept>

#include "tracer/image/raster_file.h"
#include "tracer/system/shared_library.h"

namespace durer {
namespace {

struct Jpeg {
  SharedLibrary library{DURER_JPEG_LIBRARY};
  DURER_IMPORT(jpeg_std_error);
  DURER_IMPORT(jpeg_CreateDecompress);
  DURER_IMPORT(jpeg_destroy_decompress);
  DURER_IMPORT(jpeg_stdio_src);
  DURER_IMPORT(jpeg_read_header);
  DURER_IMPORT(jpeg_start_decompress);
  DURER_IMPORT(jpeg_read_scanlines);
  DURER_IMPORT(jpeg_finish_decompress);
};

const Jpeg& libjpeg() { return loaded<Jpeg>(); }

struct ErrorHandler {
  jpeg_error_mgr base;  // first: libjpeg hands back a pointer to it
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void leave(j_common_ptr jpeg) {
  auto* handler = reinterpret_cast<ErrorHandler*>(jpeg->err);
  handler->base.format_message(jpeg, handler->message);
  std::longjmp(handler->jump, 1);
}

// A file that ends too soon is refused, other damage is passed over, as in POV-Ray.
void take_warning(j_common_ptr jpeg, int level) {
  if (level < 0 && jpeg->err->msg_code == JWRN_JPEG_EOF) leave(jpeg);
}

// What a longjmp passes over is kept outside.
bool decode(std::FILE* stream, RasterFile& file, ErrorHandler& handler) {
  jpeg_decompress_struct jpeg;
  jpeg.err = libjpeg().jpeg_std_error(&handler.base);
  handler.base.error_exit = leave;
  handler.base.emit_message = take_warning;
  if (setjmp(handler.jump)) {
    libjpeg().jpeg_destroy_decompress(&jpeg);
    return false;
  }
  libjpeg().jpeg_CreateDecompress(&jpeg, JPEG_LIB_VERSION, sizeof jpeg);
  libjpeg().jpeg_stdio_src(&jpeg, stream);
  libjpeg().jpeg_read_header(&jpeg, TRUE);
  if (jpeg.out_color_space != JCS_GRAYSCALE) jpeg.out_color_space = JCS_RGB;
  libjpeg().jpeg_start_decompress(&jpeg);
  file.width = static_cast<int>(jpeg.output_width);
  file.height = static_cast<int>(jpeg.output_height);
  file.channels = jpeg.output_components;
  const size_t stride = static_cast<size_t>(file.width) * static_cast<size_t>(file.channels);
  file.bytes.resize(stride * static_cast<size_t>(file.height));
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = file.bytes.data() + stride * jpeg.output_scanline;
    libjpeg().jpeg_read_scanlines(&jpeg, &row, 1);
  }
  libjpeg().jpeg_finish_decompress(&jpeg);
  libjpeg().jpeg_destroy_decompress(&jpeg);
  return true;
}

}  // namespace

RasterFile read_jpeg(const std::string& path) {
  const std::unique_ptr<std::FILE, decltype(&std::fclose)> stream(std::fopen(path.c_str(), "rb"),
                                                                  &std::fclose);
  if (!stream) throw std::runtime_error("the image '" + path + "' cannot be opened");
  RasterFile file;
  ErrorHandler handler;
  if (!decode(stream.get(), file, handler)) {
    throw std::runtime_error("the image '" + path + "' is no readable JPEG: " + handler.message);
  }
  return file;
}

}  // namespace durer
