// PNG files through libpng.
#pragma once

#include <string>

#include "tracer/image/quantize.h"

namespace durer {

// Writes under a temporary name in the same folder, then renames: nobody sees half a picture.
// "-" writes to standard output. Throws std::runtime_error with the system's reason.
void write_png(const std::string& path, const Framebuffer& picture, const PixelFormat& format);

}  // namespace durer
