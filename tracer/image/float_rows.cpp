#include "tracer/image/float_rows.h"

#include <algorithm>
#include <cmath>

namespace durer {

LinearRows::LinearRows(const PixelFormat& format, int width)
    : format_(format), width_(width), decode_(format.working, TransferCurve::neutral()) {}

void LinearRows::convert(const PixelColor* pixels, float* out) const {
  for (int x = 0; x < width_; ++x) {
    *out++ = decode_(pixels[x].color.red);
    *out++ = decode_(pixels[x].color.green);
    *out++ = decode_(pixels[x].color.blue);
    if (format_.alpha) *out++ = 1 - pixels[x].transmit;
  }
}

RgbeRows::RgbeRows(const PixelFormat& format, int width)
    : width_(width),
      decode_(format.working, TransferCurve::neutral()),
      dithering_(format.dither, width) {}

void RgbeRows::quantize_row(int y, const PixelColor* pixels, float* out) {
  for (int x = 0; x < width_; ++x) {
    Channels light{decode_(pixels[x].color.red), decode_(pixels[x].color.green),
                   decode_(pixels[x].color.blue), 0};
    if (dithering_.diffuses()) {
      const Channels error = dithering_.error_at(x);
      for (size_t c = 0; c < 3; ++c) light[c] += error[c];
    }
    const float offset = dithering_.offset(x, y);
    const float greatest = std::max({light[0], light[1], light[2]});
    Channels lost{};
    if (!(greatest > 1e-32f)) {
      for (int c = 0; c < 3; ++c) *out++ = 0;
      lost = light;
    } else {
      int exponent;
      const float mantissa = std::frexp(greatest, &exponent);
      const float scale = 256 * mantissa / greatest, step = greatest / (256 * mantissa);
      for (size_t c = 0; c < 3; ++c) {
        const float byte = std::floor(std::clamp(light[c] * scale + offset, 0.0f, 255.0f));
        *out++ = byte * step;
        lost[c] = light[c] - (byte + 0.5f) * step;
      }
    }
    if (dithering_.diffuses()) dithering_.spread(x, lost);
  }
}

}  // namespace durer
