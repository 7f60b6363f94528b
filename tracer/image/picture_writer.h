// Picture files: PNG through libpng, PPM, BMP and Targa by itself, all other formats through the
// module with OpenImageIO.
#pragma once

#include <cstdio>
#include <string>

#include "tracer/image/quantize.h"

namespace durer {

enum class PictureFileType { png, tga, tga_rle, jpeg, ppm, bmp, exr, hdr, tiff };

struct PictureOutput {
  PictureFileType type = PictureFileType::png;
  PixelFormat format;
  // JPEG: quality 2..100, otherwise 85; PNG: level 1..9, otherwise a quick one.
  int compression = 0;
};

// Writes under a temporary name in the same folder, then renames: nobody sees half a picture.
// "-" writes to standard output. Throws std::runtime_error with the system's reason.
void write_picture_file(const std::string& path, const Picture& picture,
                        const PictureOutput& output);

// The encoders, for the above. They throw with a broken file behind them.
void encode_png(std::FILE* file, const Picture& picture, const PictureOutput& output);
void encode_pnm(std::FILE* file, const Picture& picture, const PictureOutput& output);
void encode_bmp(std::FILE* file, const Picture& picture, const PictureOutput& output);
void encode_tga(std::FILE* file, const Picture& picture, const PictureOutput& output);
// `file` must be open for reading, too, and able to seek.
void encode_with_openimageio(std::FILE* file, const Picture& picture, const PictureOutput& output);

}  // namespace durer
