// Radiance files, and kinds of BMP that POV-Ray does not know, through stb_image, which needs no time
// to load.
#include <stb/stb_image.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "tracer/image/raster_file.h"

namespace durer {
namespace {

template <typename Value>
using Pixels = std::unique_ptr<Value, decltype(&stbi_image_free)>;

size_t value_count(const RasterFile& file) {
  return static_cast<size_t>(file.width) * static_cast<size_t>(file.height) *
         static_cast<size_t>(file.channels);
}

// Each stored byte stands for the middle of its step: half a step is added to the channels of a pixel,
// whose greatest byte is at least 128 (spec/shading.md 6.3).
void centre_steps(std::vector<float>& rgb) {
  for (size_t i = 0; i + 3 <= rgb.size(); i += 3) {
    const float greatest = std::max({rgb[i], rgb[i + 1], rgb[i + 2]});
    if (greatest <= 0) continue;
    const float half_step = std::ldexp(0.5f, std::ilogb(greatest) - 7);
    for (size_t c = 0; c < 3; ++c) rgb[i + c] += half_step;
  }
}

[[noreturn]] void fail(const std::string& path) {
  const char* reason = stbi_failure_reason();
  throw std::runtime_error("the image '" + path +
                           "' cannot be read: " + (reason ? reason : "unknown format"));
}

}  // namespace

RasterFile read_with_stb(const std::string& path) {
  RasterFile file;
  const Pixels<stbi_uc> pixels(
      stbi_load(path.c_str(), &file.width, &file.height, &file.channels, 0), &stbi_image_free);
  if (!pixels) fail(path);
  file.bytes.assign(pixels.get(), pixels.get() + value_count(file));
  return file;
}

RasterFile read_hdr(const std::string& path) {
  RasterFile file;
  if (!stbi_is_hdr(path.c_str())) {
    throw std::runtime_error("the image '" + path + "' is no readable Radiance HDR file");
  }
  const Pixels<float> pixels(
      stbi_loadf(path.c_str(), &file.width, &file.height, &file.channels, 0), &stbi_image_free);
  if (!pixels) fail(path);
  file.bits = 32;
  file.floats.assign(pixels.get(), pixels.get() + value_count(file));
  if (file.channels == 3) centre_steps(file.floats);
  return file;
}

}  // namespace durer
