#include "tracer/image/raster_file.h"

#include <algorithm>
#include <cctype>

namespace durer {

ImageFileType image_type_of(const std::string& path) {
  const size_t dot = path.rfind('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  struct Entry {
    const char* extension;
    ImageFileType type;
  };
  static constexpr Entry kEntries[] = {
      {"tga", ImageFileType::tga},  {"ppm", ImageFileType::ppm},   {"pgm", ImageFileType::pgm},
      {"gif", ImageFileType::gif},  {"iff", ImageFileType::iff},   {"jpg", ImageFileType::jpeg},
      {"jpeg", ImageFileType::jpeg}, {"tif", ImageFileType::tiff}, {"tiff", ImageFileType::tiff},
      {"bmp", ImageFileType::bmp},  {"exr", ImageFileType::exr},   {"hdr", ImageFileType::hdr},
      {"pot", ImageFileType::pot}};
  for (const Entry& entry : kEntries)
    if (extension == entry.extension) return entry.type;
  return ImageFileType::png;
}

namespace {

// Rounded as libtiff does it for POV-Ray, to whom every TIFF counts as premultiplied.
template <typename Value>
void premultiply(std::vector<Value>& values, int channels, uint32_t maximum) {
  const size_t step = static_cast<size_t>(channels);
  for (size_t i = 0; i + step <= values.size(); i += step) {
    const uint32_t alpha = values[i + step - 1];
    for (size_t c = 0; c + 1 < step; ++c) {
      values[i + c] = static_cast<Value>((values[i + c] * alpha + maximum / 2) / maximum);
    }
  }
}

void premultiply(RasterFile& file) {
  if (!file.has_alpha()) return;
  if (file.bits == 8) premultiply(file.bytes, file.channels, 255);
  if (file.bits == 16) premultiply(file.words, file.channels, 65535);
}

}  // namespace

RasterFile read_raster(const ImageSource& source) {
  RasterFile file;
  if (source.function) {
    file.width = source.function->width;
    file.height = source.function->height;
    file.channels = source.function->channels;
    file.bits = 16;
    file.words = source.function->values;
    file.type = ImageFileType::function;
    return file;
  }
  const ImageFileType type =
      source.type == ImageFileType::by_name ? image_type_of(source.path) : source.type;
  switch (type) {
    case ImageFileType::png: file = read_png(source.path); break;
    case ImageFileType::ppm:
    case ImageFileType::pgm: file = read_pnm(source.path); break;
    case ImageFileType::jpeg: file = read_jpeg(source.path); break;
    case ImageFileType::tga:
    case ImageFileType::bmp: file = read_tga_or_bmp(source.path); break;
    case ImageFileType::hdr: file = read_hdr(source.path); break;
    case ImageFileType::gif: file = read_gif(source.path); break;
    case ImageFileType::pot: file = read_pot(source.path); break;
    default: file = read_with_openimageio(source.path); break;
  }
  if (type == ImageFileType::tiff && file.straight_alpha) premultiply(file);
  file.type = type;
  return file;
}

}  // namespace durer
