// From the framebuffer to the file that the options ask for.
#pragma once

#include <string>

#include "cli/options.h"
#include "tracer/image/picture_writer.h"
#include "tracer/scene/scene.h"

namespace durer {

// How the scene's numbers become the file's (spec/shading.md 6.1).
PictureOutput picture_output(const Options& options, const Scene& scene);

// Per channel. What files of floating point numbers tell apart in the dark counts as 16 bits.
int significant_bits(const Options& options);

// Throws std::runtime_error with the system's reason.
void write_picture(const std::string& path, const Picture& picture, const Options& options,
                   const Scene& scene);

}  // namespace durer
