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

std::shared_ptr<const RasterFile> raster_of(const ImageSource& source) {
  if (source.raster) return source.raster;
  RasterFile file;
  file.width = source.function->width;
  file.height = source.function->height;
  file.channels = source.function->channels;
  file.bits = 16;
  file.words = source.function->values;
  file.type = ImageFileType::function;
  return std::make_shared<RasterFile>(std::move(file));
}

RasterFile read_raster(const std::string& path, ImageFileType type) {
  RasterFile file;
  if (type == ImageFileType::by_name) type = image_type_of(path);
  switch (type) {
    case ImageFileType::png: file = read_png(path); break;
    case ImageFileType::ppm:
    case ImageFileType::pgm: file = read_pnm(path, type); break;
    case ImageFileType::jpeg: file = read_jpeg(path); break;
    case ImageFileType::tga:
    case ImageFileType::bmp: file = read_tga_or_bmp(path); break;
    case ImageFileType::hdr: file = read_hdr(path); break;
    case ImageFileType::gif: file = read_gif(path); break;
    case ImageFileType::pot: file = read_pot(path); break;
    default: file = read_with_openimageio(path); break;
  }
  if (type == ImageFileType::tiff && file.straight_alpha) premultiply(file);
  file.type = type;
  return file;
}

}  // namespace durer
