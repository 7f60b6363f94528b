#include <gif_lib.h>

#include <memory>
#include <stdexcept>

#include "tracer/image/raster_file.h"
#include "tracer/system/shared_library.h"

namespace durer {
namespace {

struct Gif {
  SharedLibrary library{DURER_GIF_LIBRARY};
  DURER_IMPORT(DGifOpenFileName);
  DURER_IMPORT(DGifGetRecordType);
  DURER_IMPORT(DGifGetImageDesc);
  DURER_IMPORT(DGifGetLine);
  DURER_IMPORT(DGifGetExtension);
  DURER_IMPORT(DGifGetExtensionNext);
  DURER_IMPORT(DGifExtensionToGCB);
  DURER_IMPORT(DGifCloseFile);
};

const Gif& giflib() { return loaded<Gif>(); }

using OpenGif = std::unique_ptr<GifFileType, void (*)(GifFileType*)>;

[[noreturn]] void fail(const std::string& path) {
  throw std::runtime_error("the image '" + path + "' is no readable GIF");
}

// Goes on to the first image. Returns the index that an extension before it makes transparent, or
// NO_TRANSPARENT_COLOR.
int read_up_to_image(GifFileType* gif, const std::string& path) {
  GraphicsControlBlock control{};
  control.TransparentColor = NO_TRANSPARENT_COLOR;
  for (GifRecordType record{}; giflib().DGifGetRecordType(gif, &record) == GIF_OK;) {
    if (record == IMAGE_DESC_RECORD_TYPE && giflib().DGifGetImageDesc(gif) == GIF_OK)
      return control.TransparentColor;
    if (record != EXTENSION_RECORD_TYPE) break;
    int function = 0;
    GifByteType* data = nullptr;  // the first byte says how many follow
    if (giflib().DGifGetExtension(gif, &function, &data) != GIF_OK) break;
    if (data && function == GRAPHICS_EXT_FUNC_CODE)
      giflib().DGifExtensionToGCB(data[0], data + 1, &control);
    while (data)
      if (giflib().DGifGetExtensionNext(gif, &data) != GIF_OK) fail(path);
  }
  fail(path);
}

}  // namespace

// The first image, and nothing behind it. The rows of interlaced ones are shown in the order of the
// file, as POV-Ray shows them.
RasterFile read_gif(const std::string& path) {
  int code = 0;
  const OpenGif open(giflib().DGifOpenFileName(path.c_str(), &code), [](GifFileType* gif) {
    if (gif) giflib().DGifCloseFile(gif, nullptr);
  });
  GifFileType* gif = open.get();
  if (!gif) throw std::runtime_error("the image '" + path + "' cannot be opened as GIF");
  const int transparent = read_up_to_image(gif, path);
  const ColorMapObject* colors = gif->Image.ColorMap ? gif->Image.ColorMap : gif->SColorMap;
  if (!colors) fail(path);
  RasterFile file;
  file.width = gif->Image.Width;
  file.height = gif->Image.Height;
  check_size(path, file.width, file.height);
  const size_t width = static_cast<size_t>(file.width);
  file.bytes.resize(width * static_cast<size_t>(file.height));
  for (size_t i = 0; i < file.bytes.size(); i += width)
    if (giflib().DGifGetLine(gif, &file.bytes[i], file.width) != GIF_OK) fail(path);
  for (int i = 0; i < colors->ColorCount; ++i) {
    const GifColorType& c = colors->Colors[i];
    file.add_to_palette({c.Red, c.Green, c.Blue, i == transparent ? uint8_t{0} : uint8_t{255}});
  }
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
