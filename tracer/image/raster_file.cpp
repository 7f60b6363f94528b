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
    case ImageFileType::gif: file = read_gif(source.path); break;
    case ImageFileType::pot: file = read_pot(source.path); break;
    default: file = read_with_openimageio(source.path); break;
  }
  file.type = type;
  return file;
}

}  // namespace durer
