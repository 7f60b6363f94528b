// The numbers of a picture file before any meaning is given to them (spec/textures.md 12).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tracer/scene/image_source.h"

namespace durer {

// What the file says about its transfer curve.
struct FileGamma {
  enum class Kind : uint8_t { none, srgb, power };
  Kind kind = Kind::none;
  double gamma = 1;  // of the picture: value = light^(1/gamma)
};

struct RasterFile {
  int width = 0, height = 0;
  int channels = 1;  // grey, grey + alpha, RGB, RGBA; row 0 on top
  int bits = 8;      // 8: bytes, 16: words, 32: floats is filled
  int maximum = 0;   // the value of full light; 0: the greatest that the bits can hold
  std::vector<uint8_t> bytes;
  std::vector<uint16_t> words;
  std::vector<float> floats;
  // Colour-mapped: bytes holds one index per pixel, channels is 1.
  // Its entries are RGBA, 65535 is full light.
  std::vector<std::array<uint16_t, 4>> palette;
  FileGamma gamma;
  bool straight_alpha = false;  // the file says that colours are not multiplied by alpha
  ImageFileType type = ImageFileType::png;

  void add_to_palette(const std::array<uint8_t, 4>& rgba) {
    auto& entry = palette.emplace_back();
    for (size_t c = 0; c < 4; ++c) entry[c] = static_cast<uint16_t>(rgba[c] * 257);
  }
  bool is_palette() const { return !palette.empty(); }
  bool has_alpha() const { return channels == 2 || channels == 4; }
};

// Throws std::runtime_error with a text for the user. `by_name`: the name's extension tells the type.
RasterFile read_raster(const std::string& path, ImageFileType type);
// Of a source that was parsed.
std::shared_ptr<const RasterFile> raster_of(const ImageSource& source);

// By the name's extension; PNG where that says nothing.
ImageFileType image_type_of(const std::string& path);

// Throws if a file claims a size that it cannot hold however well it is compressed, before memory is
// taken for it.
void check_size(const std::string& path, int64_t width, int64_t height);

RasterFile read_png(const std::string& path);
// `ppm` means colours (P3, P6), `pgm` greys (P2, P5).
RasterFile read_pnm(const std::string& path, ImageFileType type);
RasterFile read_jpeg(const std::string& path);
RasterFile read_tga(const std::string& path);
RasterFile read_bmp(const std::string& path);
RasterFile read_with_stb(const std::string& path);
RasterFile read_hdr(const std::string& path);
RasterFile read_gif(const std::string& path);
// A word-valued picture in the two halves of a gif's lines (spec/geometry.md 12.14).
RasterFile read_pot(const std::string& path);
RasterFile read_tiff(const std::string& path);
RasterFile read_exr(const std::string& path);
// All other formats: through the module that holds OpenImageIO, loaded when first needed.
RasterFile read_with_openimageio(const std::string& path);

}  // namespace durer
