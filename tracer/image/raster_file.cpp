#include "tracer/image/raster_file.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

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

void check_size(const std::string& path, int64_t width, int64_t height) {
  constexpr int64_t kAlwaysTaken = int64_t{1} << 26, kLargest = int64_t{1} << 32;
  constexpr int64_t kPixelsPerByte = 4096;  // deflate, the best of them, makes 1032 bytes of one
  if (width <= 0 || height <= 0 || width >= kLargest / height)
    throw std::runtime_error("the image '" + path + "' has an impossible size");
  std::error_code ignored;
  const auto bytes = static_cast<int64_t>(std::filesystem::file_size(path, ignored));
  if (width * height > std::max(kAlwaysTaken, kPixelsPerByte * bytes))
    throw std::runtime_error("the image '" + path + "' is too short for its size");
}

namespace {

// Every TIFF counts as premultiplied to POV-Ray. Integers have been multiplied by libtiff.
void premultiply(RasterFile& file) {
  if (!file.has_alpha()) return;
  const size_t step = static_cast<size_t>(file.channels);
  for (size_t i = 0; i + step <= file.floats.size(); i += step) {
    for (size_t c = 0; c + 1 < step; ++c) file.floats[i + c] *= file.floats[i + step - 1];
  }
}

// OpenImageIO would read pictures of any kind under this name.
void check_iff(const std::string& path) {
  char head[4] = {};
  std::ifstream(path, std::ios::binary).read(head, sizeof head);
  if (std::memcmp(head, "FOR", 3) != 0)
    throw std::runtime_error("the image '" + path + "' is no readable file of its kind, IFF");
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
    case ImageFileType::tga: file = read_tga(path); break;
    case ImageFileType::bmp: file = read_bmp(path); break;
    case ImageFileType::hdr: file = read_hdr(path); break;
    case ImageFileType::gif: file = read_gif(path); break;
    case ImageFileType::tiff: file = read_tiff(path); break;
    case ImageFileType::exr: file = read_exr(path); break;
    case ImageFileType::pot: file = read_pot(path); break;
    default:
      check_iff(path);
      file = read_with_openimageio(path);
      break;
  }
  // A BMP may say that it has no rows, and stb_image believes it.
  if (file.width < 1 || file.height < 1)
    throw std::runtime_error("the image '" + path + "' has no pixels");
  if (type == ImageFileType::tiff && file.straight_alpha) premultiply(file);
  file.type = type;
  return file;
}

}  // namespace durer
