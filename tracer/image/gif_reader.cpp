#include <gif_lib.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "tracer/image/raster_file.h"
#include "tracer/system/shared_library.h"

namespace durer {
namespace {

struct Gif {
  SharedLibrary library{DURER_GIF_LIBRARY};
  DURER_IMPORT(DGifOpenFileName);
  DURER_IMPORT(DGifSlurp);
  DURER_IMPORT(DGifSavedExtensionToGCB);
  DURER_IMPORT(DGifCloseFile);
};

const Gif& giflib() { return loaded<Gif>(); }

// Puts the rows of an interlaced image back into the order that the file has them in: POV-Ray shows
// them so.
std::vector<uint8_t> rows_as_stored(const std::vector<uint8_t>& rows, int width, int height) {
  struct Pass {
    int first, step;
  };
  constexpr std::array<Pass, 4> kPasses{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
  std::vector<uint8_t> stored(rows.size());
  uint8_t* to = stored.data();
  for (const Pass& pass : kPasses)
    for (int y = pass.first; y < height; y += pass.step, to += width)
      std::memcpy(to, rows.data() + static_cast<size_t>(y) * width, width);
  return stored;
}

}  // namespace

RasterFile read_gif(const std::string& path) {
  int code = 0;
  GifFileType* gif = giflib().DGifOpenFileName(path.c_str(), &code);
  if (!gif) throw std::runtime_error("the image '" + path + "' cannot be opened as GIF");
  const bool read = giflib().DGifSlurp(gif) == GIF_OK && gif->ImageCount > 0;
  const SavedImage* image = read ? &gif->SavedImages[0] : nullptr;
  const ColorMapObject* colors = nullptr;
  if (image) colors = image->ImageDesc.ColorMap ? image->ImageDesc.ColorMap : gif->SColorMap;
  RasterFile file;
  if (colors) {
    file.width = image->ImageDesc.Width;
    file.height = image->ImageDesc.Height;
    file.bytes.assign(image->RasterBits,
                      image->RasterBits + static_cast<size_t>(file.width) * file.height);
    if (image->ImageDesc.Interlace)
      file.bytes = rows_as_stored(file.bytes, file.width, file.height);
    GraphicsControlBlock control{};
    const bool has_control = giflib().DGifSavedExtensionToGCB(gif, 0, &control) == GIF_OK;
    for (int i = 0; i < colors->ColorCount; ++i) {
      const GifColorType& c = colors->Colors[i];
      const bool transparent = has_control && control.TransparentColor == i;
      file.add_to_palette({c.Red, c.Green, c.Blue, transparent ? uint8_t{0} : uint8_t{255}});
    }
  }
  giflib().DGifCloseFile(gif, &code);
  if (!colors) throw std::runtime_error("the image '" + path + "' is no readable GIF");
  return file;
}

RasterFile read_pot(const std::string& path) {
  const RasterFile halves = read_gif(path);
  RasterFile file;
  file.width = halves.width / 2;
  file.height = halves.height;
  file.bits = 16;
  for (int y = 0; y < file.height; ++y) {
    const uint8_t* row = halves.bytes.data() + static_cast<size_t>(y) * halves.width;
    for (int x = 0; x < file.width; ++x)
      file.words.push_back(static_cast<uint16_t>(row[x] << 8 | row[x + file.width]));
  }
  return file;
}

}  // namespace durer
