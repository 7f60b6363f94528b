#include "tracer/image/transfer.h"

#include <algorithm>
#include <cmath>

namespace durer {

TransferCurve TransferCurve::power(double gamma) {
  if (std::abs(1 - 1 / gamma) <= 0.01) return {};
  return {Kind::power, static_cast<float>(gamma)};
}

float TransferCurve::encode(float x) const {
  switch (kind) {
    case Kind::neutral:
      return x;
    case Kind::power:
      return std::pow(std::max(x, 0.0f), 1 / gamma);
    case Kind::srgb:
      return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
  }
  return x;
}

float TransferCurve::decode(float x) const {
  switch (kind) {
    case Kind::neutral:
      return x;
    case Kind::power:
      return std::pow(std::max(x, 0.0f), gamma);
    case Kind::srgb:
      return x < 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  }
  return x;
}

OutputTransfer::OutputTransfer(const TransferCurve& working, const TransferCurve& file)
    : decode_(working), encode_(file) {
  if (working == file) {
    decode_ = encode_ = {};
  } else if (working.kind == TransferCurve::Kind::power &&
             file.kind == TransferCurve::Kind::power) {
    decode_ = {};
    encode_ = TransferCurve::power(file.gamma / working.gamma);
  }
}

float OutputTransfer::operator()(float value) const {
  return encode_.encode(decode_.decode(value));
}

}  // namespace durer
