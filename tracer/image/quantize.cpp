#include "tracer/image/quantize.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace durer {
namespace {

// A file without premultiplication: colour divided by an alpha that highlights may raise.
void unpremultiply(RGB& color, float& alpha) {
  const float brightness = color.grey();
  if (brightness > alpha) alpha = std::min(1.0f, brightness);
  const float divisor = alpha == 0 ? 1e-6f : alpha;
  color = {color.red / divisor, color.green / divisor, color.blue / divisor};
}

// The comparison sends NaN to 0.
float clip(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }

// Finding the least value of each code takes some 25 evaluations of the curve.
constexpr int kMostTabulated = 1023;

// Values in (0,1] by their exponent and the first bits of their mantissa.
constexpr uint32_t kIndexBits = 7;
constexpr uint32_t kIndexShift = 23 - kIndexBits;
constexpr uint32_t kLeastExponent = 127 - 20;  // below 2^-20 all curves give code 0 or nearly so
constexpr uint32_t kFirstIndex = kLeastExponent << kIndexBits;
constexpr uint32_t kLastIndex = 127u << kIndexBits;  // of 1.0

uint32_t table_index(float value) {
  const uint32_t index = std::bit_cast<uint32_t>(value) >> kIndexShift;
  return index < kFirstIndex ? 0 : std::min(index, kLastIndex) - kFirstIndex + 1;
}

}  // namespace

Dithering::Dithering(DitherMethod method, int width)
    : method_(method),
      diffuses_(method == DitherMethod::diffusion1 || method == DitherMethod::diffusion2 ||
                method == DitherMethod::floyd_steinberg) {
  if (!diffuses_) return;
  row_.resize(static_cast<size_t>(width) + 2);
  next_.resize(static_cast<size_t>(width) + 2);
}

float Dithering::offset(int x, int y) const {
  static constexpr float k2[2][2] = {{1, 3}, {4, 2}};
  static constexpr float k3[3][3] = {{3, 7, 4}, {6, 1, 9}, {2, 8, 5}};
  static constexpr float k4[4][4] = {{1, 9, 3, 11}, {13, 5, 15, 7}, {4, 12, 2, 10}, {16, 8, 14, 6}};
  switch (method_) {
    case DitherMethod::bayer2:
      return k2[x % 2][y % 2] / 4 - 0.5f;
    case DitherMethod::bayer3:
      return k3[x % 3][y % 3] / 9 - 0.5f;
    case DitherMethod::bayer4:
      return k4[x % 4][y % 4] / 16 - 0.5f;
    default:
      return 0;
  }
}

Channels Dithering::error_at(int x) const {
  return method_ == DitherMethod::diffusion1 ? carried_ : row_[static_cast<size_t>(x) + 1];
}

void Dithering::spread(int x, const Channels& lost) {
  if (method_ == DitherMethod::diffusion1) {
    carried_ = lost;
    return;
  }
  if (x == 0) {
    std::swap(row_, next_);
    std::fill(next_.begin(), next_.end(), Channels{});
  }
  const size_t i = static_cast<size_t>(x) + 1;
  for (size_t c = 0; c < kMostChannels; ++c) {
    if (method_ == DitherMethod::diffusion2) {
      row_[i + 1][c] += lost[c] / 2;
      next_[i][c] += lost[c] / 4;
      next_[i + 1][c] += lost[c] / 4;
    } else {
      row_[i + 1][c] += lost[c] * 7 / 16;
      next_[i - 1][c] += lost[c] * 3 / 16;
      next_[i][c] += lost[c] * 5 / 16;
      next_[i + 1][c] += lost[c] / 16;
    }
  }
}

CodeTable::CodeTable(const OutputTransfer& transfer, int most)
    : transfer_(transfer), most_(static_cast<float>(most)) {
  if (most > kMostTabulated) return;
  // Positive floats are ordered like their bits, and every curve rises: bisection.
  least_.push_back(-std::numeric_limits<float>::infinity());
  uint32_t low = 0;
  const uint32_t one = std::bit_cast<uint32_t>(1.0f);
  for (int code = 1; code <= most; ++code) {
    uint32_t high = one;
    while (low < high) {
      const uint32_t middle = low + (high - low) / 2;
      if (code_by_curve(std::bit_cast<float>(middle)) >= code) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    least_.push_back(std::bit_cast<float>(low));
  }
  // No value is as much as that: searches end there.
  least_.push_back(std::numeric_limits<float>::quiet_NaN());
  for (uint32_t i = kFirstIndex; i <= kLastIndex + 1; ++i) {
    const float start = i == kFirstIndex ? 0 : std::bit_cast<float>((i - 1) << kIndexShift);
    const auto above = std::upper_bound(least_.begin(), least_.end() - 1, start);
    first_.push_back(static_cast<uint16_t>(above - least_.begin() - 1));
  }
}

uint16_t CodeTable::code_by_curve(float value) const {
  return static_cast<uint16_t>(std::floor(clip(transfer_(value)) * most_ + 0.5f));
}

inline uint16_t CodeTable::operator()(float value) const {
  if (least_.empty()) [[unlikely]]
    return code_by_curve(value);
  if (!(value > 0)) return 0;
  size_t code = first_[table_index(value)];
  while (value >= least_[code + 1]) ++code;
  return static_cast<uint16_t>(code);
}

void CodeTable::encode_colors(const PixelColor* pixels, int count, uint16_t* out) const {
  for (const PixelColor* pixel = pixels; pixel != pixels + count; ++pixel) {
    *out++ = (*this)(pixel->color.red);
    *out++ = (*this)(pixel->color.green);
    *out++ = (*this)(pixel->color.blue);
  }
}

Quantizer::Quantizer(const PixelFormat& format, int width)
    : format_(format),
      width_(width),
      most_(static_cast<float>((1 << format.bits) - 1)),
      encode_(format.working, format.file),
      decode_(format.file, format.working),
      codes_(encode_, (1 << format.bits) - 1),
      dithering_(format.dither, width) {}

void Quantizer::quantize_row(int y, const PixelColor* pixels, uint16_t* out) {
  const size_t channels = static_cast<size_t>(format_.channels());
  const size_t colors = format_.greyscale ? 1 : 3;
  if (channels == 3 && format_.dither == DitherMethod::none) {
    codes_.encode_colors(pixels, width_, out);
    return;
  }
  for (int x = 0; x < width_; ++x) {
    RGB color = pixels[x].color;
    float alpha = 1 - pixels[x].transmit;
    if (format_.alpha && !format_.premultiplied) unpremultiply(color, alpha);
    Channels linear{color.red, color.green, color.blue, alpha};
    if (format_.greyscale) linear = {color.grey(), alpha, 0, 0};

    if (format_.dither == DitherMethod::none) {
      for (size_t c = 0; c < colors; ++c) *out++ = codes_(linear[c]);
      if (format_.alpha) {
        *out++ = static_cast<uint16_t>(std::floor(clip(linear[colors]) * most_ + 0.5f));
      }
      continue;
    }
    const float offset = dithering_.offset(x, y) / most_;
    const Channels error = dithering_.diffuses() ? dithering_.error_at(x) : Channels{};
    Channels lost{};
    for (size_t c = 0; c < channels; ++c) {
      const bool is_alpha = c == colors;
      const float value = linear[c] + error[c];
      const float encoded = is_alpha ? value : encode_(value);
      const float code = std::floor(clip(encoded + offset) * most_ + 0.5f);
      *out++ = static_cast<uint16_t>(code);
      const float written = code / most_;
      lost[c] = clip(value) - (is_alpha ? written : decode_(written));
    }
    if (dithering_.diffuses()) dithering_.spread(x, lost);
  }
}

}  // namespace durer
