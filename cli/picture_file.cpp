#include "cli/picture_file.h"

#include <unistd.h>

#include <cstdio>

#include "cli/output_name.h"
#include "tracer/image/png_writer.h"

namespace durer {

std::string unsupported_format(const Options& options) {
  if (!options.output_to_file || options.file_type == 'N') return "";
  return std::string("writing .") + extension_of(options.file_type) + " pictures";
}

PixelFormat pixel_format(const Options& options, const Scene& scene) {
  PixelFormat format;
  format.file = options.file_curve;
  switch (scene.settings.gamma_kind) {
    case AssumedGamma::srgb:
      format.working = TransferCurve::srgb();
      break;
    case AssumedGamma::power:
      format.working = TransferCurve::power(scene.settings.assumed_gamma);
      break;
    case AssumedGamma::none:
      // Scenes of the time before 3.7 are written unconverted, unless the user says "3.7".
      format.working = TransferCurve::neutral();
      if (scene.effective_version < 370 && options.language_version < 370) {
        format.file = TransferCurve::neutral();
      }
      break;
  }
  format.bits = options.bits;
  format.alpha = options.output_alpha;
  format.greyscale = options.greyscale;
  // POV-Ray's grey PNG always has 16 bits.
  if (options.greyscale && options.file_type == 'N') format.bits = 16;
  format.dither = options.dither;
  return format;
}

void write_picture(const std::string& path, const Framebuffer& picture, const Options& options,
                   const Scene& scene) {
  const PixelFormat format = pixel_format(options, scene);
  if (path == "stderr") {
    // What goes to standard output from here on is the picture only.
    std::fflush(stdout);
    dup2(STDERR_FILENO, STDOUT_FILENO);
  }
  write_png(is_standard_stream(path) ? "-" : path, picture, format);
}

}  // namespace durer
