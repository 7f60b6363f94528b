// From the framebuffer to the file that the options ask for.
#pragma once

#include <string>

#include "cli/options.h"
#include "tracer/image/framebuffer.h"
#include "tracer/scene/scene.h"

namespace durer {

// Empty: the picture can be written; otherwise the name of the format that cannot be yet.
std::string unsupported_format(const Options& options);

// How the scene's numbers become the file's (spec/shading.md 6.1).
PixelFormat pixel_format(const Options& options, const Scene& scene);

// Throws std::runtime_error with the system's reason.
void write_picture(const std::string& path, const Framebuffer& picture, const Options& options,
                   const Scene& scene);

}  // namespace durer
