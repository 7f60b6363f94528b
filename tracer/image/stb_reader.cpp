// Kinds of BMP that POV-Ray does not know, through stb_image, which needs no time to load.
#include <stb/stb_image.h>

#include <memory>
#include <stdexcept>

#include "tracer/image/raster_file.h"

namespace durer {
namespace {

size_t value_count(const RasterFile& file) {
  return static_cast<size_t>(file.width) * static_cast<size_t>(file.height) *
         static_cast<size_t>(file.channels);
}

[[noreturn]] void fail(const std::string& path) {
  const char* reason = stbi_failure_reason();
  throw std::runtime_error("the image '" + path +
                           "' cannot be read: " + (reason ? reason : "unknown format"));
}

}  // namespace

RasterFile read_with_stb(const std::string& path) {
  RasterFile file;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load(path.c_str(), &file.width, &file.height, &file.channels, 0), &stbi_image_free);
  if (!pixels) fail(path);
  file.bytes.assign(pixels.get(), pixels.get() + value_count(file));
  return file;
}

}  // namespace durer
