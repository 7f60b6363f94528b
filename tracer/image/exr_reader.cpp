// OpenEXR files through the library's C interface to its RGBA files, which gives what POV-Ray gets:
// half floats, the channels R, G, B, A, or Y with its chroma, and no others (decision 0053).
#include <OpenEXR/ImfCRgbaFile.h>

#include <cstdint>
#include <memory>
#include <stdexcept>

#include "tracer/image/raster_file.h"
#include "tracer/system/shared_library.h"

namespace durer {
namespace {

struct OpenExr {
  SharedLibrary library{DURER_OPENEXR_LIBRARY};
  DURER_IMPORT(ImfOpenInputFile);
  DURER_IMPORT(ImfCloseInputFile);
  DURER_IMPORT(ImfInputHeader);
  DURER_IMPORT(ImfInputChannels);
  DURER_IMPORT(ImfInputSetFrameBuffer);
  DURER_IMPORT(ImfInputReadPixels);
  DURER_IMPORT(ImfHeaderDataWindow);
  DURER_IMPORT(ImfHalfToFloatArray);
  DURER_IMPORT(ImfErrorMessage);
};

const OpenExr& openexr() { return loaded<OpenExr>(); }

void close_file(ImfInputFile* file) { openexr().ImfCloseInputFile(file); }

// Where a row that starts at x = `left` would have x = 0, which may lie outside of it.
ImfRgba* origin(ImfRgba* row, int64_t left) {
  return reinterpret_cast<ImfRgba*>(reinterpret_cast<uintptr_t>(row) -
                                    static_cast<uintptr_t>(left) * sizeof(ImfRgba));
}

// As many of a pixel's floats as the picture has channels.
void append(std::vector<float>& floats, const float* rgba, int channels) {
  floats.push_back(rgba[0]);
  if (channels >= 3) floats.insert(floats.end(), {rgba[1], rgba[2]});
  if (channels == 2 || channels == 4) floats.push_back(rgba[3]);
}

}  // namespace

RasterFile read_exr(const std::string& path) {
  const auto fail = [&] {
    throw std::runtime_error("the image '" + path +
                             "' is no readable OpenEXR file: " + openexr().ImfErrorMessage());
  };
  const std::unique_ptr<ImfInputFile, void (*)(ImfInputFile*)> input(
      openexr().ImfOpenInputFile(path.c_str()), close_file);
  if (!input) fail();
  int left, top, right, bottom;
  const ImfHeader* header = openexr().ImfInputHeader(input.get());
  openexr().ImfHeaderDataWindow(header, &left, &top, &right, &bottom);
  const int64_t width = int64_t{right} - left + 1, height = int64_t{bottom} - top + 1;
  check_size(path, width, height);
  RasterFile file;
  file.width = static_cast<int>(width);
  file.height = static_cast<int>(height);
  const int present = openexr().ImfInputChannels(input.get());
  const bool is_grey = (present & IMF_WRITE_YC) == IMF_WRITE_Y;
  file.channels = (is_grey ? 1 : 3) + (present & IMF_WRITE_A ? 1 : 0);
  file.bits = 32;
  // Every row is read into the same place, and memory grows with the rows that are there: a broken
  // file may claim any number.
  std::vector<ImfRgba> halves(static_cast<size_t>(width));
  std::vector<float> values(halves.size() * 4);
  bool good = openexr().ImfInputSetFrameBuffer(input.get(), origin(halves.data(), left), 1, 0);
  for (int y = top; good && y <= bottom; ++y) {
    good = openexr().ImfInputReadPixels(input.get(), y, y);
    openexr().ImfHalfToFloatArray(static_cast<int>(values.size()), &halves[0].r, values.data());
    for (size_t i = 0; i < values.size(); i += 4) append(file.floats, &values[i], file.channels);
  }
  if (!good) fail();
  return file;
}

}  // namespace durer
