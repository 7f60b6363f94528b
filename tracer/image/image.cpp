#include "tracer/image/image.h"

#include <cmath>

#include "tracer/image/transfer.h"

namespace durer {
namespace {

// The curve of a file's colours, and whether they are then taken to the working space; nothing: the
// numbers are taken as they are.
struct Decoding {
  bool needed = false;
  bool to_working_space = false;
  TransferCurve file = TransferCurve::neutral();
};

Decoding decoding_of(const RasterFile& file, const ImageSource& source, ImageUse use,
                     const WorkingSpace& space) {
  Decoding decoding;
  const bool old = space.effective_version < 370;
  const bool unmanaged = old && space.kind == AssumedGamma::none;
  if (source.function) return decoding;
  if (source.gamma_kind != ImageGamma::automatic) {
    decoding.needed = true;
    decoding.to_working_space = use == ImageUse::color && !unmanaged;
    decoding.file = source.gamma_kind == ImageGamma::srgb ? TransferCurve::srgb()
                                                          : TransferCurve::power(source.gamma);
    return decoding;
  }
  if (use == ImageUse::raw || unmanaged) return decoding;
  switch (file.type) {
    case ImageFileType::ppm:
    case ImageFileType::pgm:
    case ImageFileType::tiff: return decoding;
    case ImageFileType::exr:
    case ImageFileType::hdr: break;  // linear
    case ImageFileType::png:
      if (file.gamma.kind == FileGamma::Kind::power) {
        decoding.file = TransferCurve::power(file.gamma.gamma);
        break;
      }
      if (file.gamma.kind == FileGamma::Kind::none && old) return decoding;
      decoding.file = TransferCurve::srgb();
      break;
    default:
      if (old) return decoding;
      decoding.file = TransferCurve::srgb();
  }
  decoding.needed = decoding.to_working_space = true;
  return decoding;
}

TransferCurve working_curve(const WorkingSpace& space) {
  switch (space.kind) {
    case AssumedGamma::srgb: return TransferCurve::srgb();
    case AssumedGamma::power: return TransferCurve::power(space.gamma);
    default: return TransferCurve::neutral();
  }
}

}  // namespace

Image::Image(std::shared_ptr<const RasterFile> raster, const ImageSource& source, ImageUse use,
             const WorkingSpace& space)
    : file_(std::move(raster)) {
  const RasterFile& file = *file_;
  const Decoding decoding = decoding_of(file, source, use, space);
  const OutputTransfer transfer(
      decoding.file, decoding.to_working_space ? working_curve(space) : TransferCurve::neutral());
  const auto decoded = [&](float v) { return decoding.needed ? transfer(v) : v; };
  if (file.is_palette()) {
    for (const auto& entry : file.palette) {
      ColorRGBFT c{decoded(static_cast<float>(entry[0]) / 65535.0f),
                   decoded(static_cast<float>(entry[1]) / 65535.0f),
                   decoded(static_cast<float>(entry[2]) / 65535.0f), 0,
                   1 - static_cast<float>(entry[3]) / 65535.0f};
      opaque_ = opaque_ && entry[3] == 65535;
      palette_.push_back(c);
    }
    // Indices beyond the palette are black.
    palette_.resize(256);
    return;
  }
  opaque_ = !file.has_alpha();
  if (file.bits == 32) {
    if (!decoding.needed) return;
    floats_ = file.floats;
    for (size_t i = 0; i < floats_.size(); ++i) {
      const bool alpha = file.has_alpha() &&
                         i % static_cast<size_t>(file.channels) ==
                             static_cast<size_t>(file.channels) - 1;
      if (!alpha) floats_[i] = decoded(floats_[i]);
    }
    return;
  }
  const int greatest = file.bits == 8 ? 255 : 65535;
  // In this order, for the last bit of POV-Ray's.
  const float of_greatest = static_cast<float>(greatest);
  const float scale =
      file.maximum ? 1 / (static_cast<float>(file.maximum) / of_greatest) : 1.0f;
  decode_.resize(static_cast<size_t>(greatest) + 1);
  for (int v = 0; v <= greatest; ++v)
    decode_[static_cast<size_t>(v)] = decoded(static_cast<float>(v) / of_greatest * scale);
  if (file.type == ImageFileType::png && file.bits == 8 && file.channels == 1)
    decode_grey_of_png();
}

// These pass through a grey palette and are cut to 8 linear bits (spec/textures.md 12.7).
void Image::decode_grey_of_png() {
  for (float& v : decode_) {
    const float grey = 0.297f * v + 0.589f * v + 0.114f * v;
    v = static_cast<float>(static_cast<int>(grey * 255)) / 255.0f;
  }
}

float Image::value(size_t position, bool alpha) const {
  if (file_->bits == 32) return floats_.empty() ? file_->floats[position] : floats_[position];
  const uint16_t stored = file_->bits == 8 ? file_->bytes[position] : file_->words[position];
  if (!alpha) return decode_[stored];
  return static_cast<float>(stored) / (file_->bits == 8 ? 255.0f : 65535.0f);
}

ColorRGBFT Image::pixel(int x, int y) const {
  if (file_->is_palette()) return palette_[file_->bytes[at(x, y)]];
  const size_t first = at(x, y) * static_cast<size_t>(file_->channels);
  ColorRGBFT c;
  c.red = value(first, false);
  if (file_->channels >= 3) {
    c.green = value(first + 1, false);
    c.blue = value(first + 2, false);
  } else {
    c.green = c.blue = c.red;
  }
  if (file_->has_alpha())
    c.transmit = 1 - value(first + static_cast<size_t>(file_->channels) - 1, true);
  return c;
}

std::shared_ptr<const Image> ImageCache::get(const ImageSource& source, ImageUse use) {
  if (source.function)
    return std::make_shared<Image>(raster_of(source), source, use, space_);
  std::shared_ptr<const Image>& image =
      images_[{source.path, static_cast<int>(source.type), static_cast<int>(use),
               static_cast<int>(source.gamma_kind), source.gamma}];
  if (!image) image = std::make_shared<Image>(raster_of(source), source, use, space_);
  return image;
}

}  // namespace durer
