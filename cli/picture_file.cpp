#include "cli/picture_file.h"

#include <unistd.h>

#include <cstdio>

#include "cli/output_name.h"

namespace durer {
namespace {

PictureFileType file_type(char letter) {
  switch (letter) {
    case 'T': return PictureFileType::tga;
    case 'C': return PictureFileType::tga_rle;
    case 'J': return PictureFileType::jpeg;
    case 'P': return PictureFileType::ppm;
    case 'B': return PictureFileType::bmp;
    case 'E': return PictureFileType::exr;
    case 'H': return PictureFileType::hdr;
    case 'F': return PictureFileType::tiff;
    default: return PictureFileType::png;
  }
}

bool has_alpha(PictureFileType type) {
  return type != PictureFileType::jpeg && type != PictureFileType::ppm &&
         type != PictureFileType::hdr;
}

bool has_dithering(PictureFileType type) {
  return type != PictureFileType::jpeg && type != PictureFileType::exr;
}

// Formats with other bits than 8 per channel.
bool has_free_bits(PictureFileType type) {
  return type == PictureFileType::png || type == PictureFileType::ppm;
}

int bits_per_channel(const Options& options, PictureFileType type) {
  // POV-Ray's grey PNG always has 16 bits.
  if (options.greyscale && type == PictureFileType::png) return 16;
  if (has_free_bits(type)) return options.bits;
  return type == PictureFileType::tiff && options.bits > 8 ? 16 : 8;
}

}  // namespace

PictureOutput picture_output(const Options& options, const Scene& scene) {
  PictureOutput output;
  output.type = file_type(options.file_type);
  output.compression = options.compression;
  PixelFormat& format = output.format;
  format.file = options.file_curve;
  switch (scene.settings.gamma_kind) {
    case AssumedGamma::srgb:
      format.working = TransferCurve::srgb();
      break;
    case AssumedGamma::power:
      format.working = TransferCurve::power(scene.settings.assumed_gamma);
      break;
    case AssumedGamma::none:
      format.working = TransferCurve::neutral();
      // Scenes of the time before 3.7 are written unconverted, unless the user says "3.7", and count as
      // sRGB: a PNG says so, files of linear light hold their decoded colours (measured on povray 3.7).
      if (scene.effective_version < 370 && options.language_version < 370) {
        format.working = format.file = TransferCurve::srgb();
      }
      break;
  }
  format.bits = bits_per_channel(options, output.type);
  format.alpha = options.output_alpha && has_alpha(output.type);
  format.greyscale = options.greyscale;
  // POV-Ray's grey PPM holds the numbers of the working space.
  if (options.greyscale && output.type == PictureFileType::ppm) {
    format.working = format.file = TransferCurve::neutral();
  }
  if (has_dithering(output.type)) format.dither = options.dither;
  return output;
}

int significant_bits(const Options& options) {
  const PictureFileType type = file_type(options.file_type);
  const bool is_floating = type == PictureFileType::exr || type == PictureFileType::hdr;
  return is_floating ? 16 : bits_per_channel(options, type);
}

void write_picture(const std::string& path, const Picture& picture, const Options& options,
                   const Scene& scene) {
  if (path == "stderr") {
    // What goes to standard output from here on is the picture only.
    std::fflush(stdout);
    dup2(STDERR_FILENO, STDOUT_FILENO);
  }
  write_picture_file(is_standard_stream(path) ? "-" : path, picture,
                     picture_output(options, scene));
}

}  // namespace durer
