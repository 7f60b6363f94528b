// What durer and its module with OpenImageIO know of each other: two functions found by name.
#pragma once

#include <cstdio>

#include "tracer/image/raster_file.h"

namespace durer {

struct ImageFileLayout {
  const char* format;       // OpenImageIO's name of the format, also the extension
  const char* compression;  // its "compression" attribute; null: the format's default
  int width, height, channels;
  int bits;                 // 8, 16: rows of bytes or words; 32: rows of floats
  bool half;                // floats are stored as halves
  float gamma;              // that the file declares; 0: none
};

// A picture file that is being written: from its top, BMP in any order.
class ImageRowWriter {
 public:
  virtual ~ImageRowWriter() = default;
  // Both return nothing on success, else a message that lives as long as the writer.
  virtual const char* write_row(int y, const void* row) = 0;
  virtual const char* finish() = 0;
};

// Null, or a message that lives as long as the thread.
using ReadImageFunction = const char* (*)(const char* path, RasterFile* file);
// `file` is open for writing and reading and stays the caller's. Null: `*message` says why.
using OpenImageWriterFunction = ImageRowWriter* (*)(std::FILE* file, const ImageFileLayout* layout,
                                                    const char** message);

}  // namespace durer
