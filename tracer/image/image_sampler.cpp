#include <algorithm>
#include <cmath>

#include "tracer/image/image.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

// Around y, 0 on the +x side; fraction of a whole turn (spec/textures.md 5).
double azimuth_fraction(double x, double z, double radius) {
  double angle;
  if (z == 0) {
    angle = x > 0 ? 0 : M_PI;
  } else {
    angle = std::acos(x / radius);
    if (z < 0) angle = 2 * M_PI - angle;
  }
  return angle / (2 * M_PI);
}

// The same of the unit vector, as POV-Ray takes it: interpolated indices show the last digits.
double direction_fraction(const Vec3& p) {
  const Vec3 d = p / length(p);
  return azimuth_fraction(d.x, d.z, std::sqrt(d.x * d.x + d.z * d.z));
}

double wrap(double value, double size) {
  const double rest = std::fmod(value, size);
  return rest < 0 ? rest + size : rest;
}

int wrap_index(int i, int size) {
  i %= size;
  return i < 0 ? i + size : i;
}

// Sums are of double precision, as in POV-Ray: it decides which of two materials an interpolated
// material_map takes.
struct WideColor {
  double red = 0, green = 0, blue = 0, filter = 0, transmit = 0;

  WideColor() = default;
  explicit WideColor(const ColorRGBFT& c)
      : red(static_cast<double>(c.red)),
        green(static_cast<double>(c.green)),
        blue(static_cast<double>(c.blue)),
        filter(static_cast<double>(c.filter)),
        transmit(static_cast<double>(c.transmit)) {}
  WideColor operator*(double w) const {
    WideColor product;
    product.red = red * w, product.green = green * w, product.blue = blue * w;
    product.filter = filter * w, product.transmit = transmit * w;
    return product;
  }
  WideColor operator+(const WideColor& other) const {
    WideColor sum;
    sum.red = red + other.red, sum.green = green + other.green, sum.blue = blue + other.blue;
    sum.filter = filter + other.filter, sum.transmit = transmit + other.transmit;
    return sum;
  }
  ColorRGBFT narrow() const {
    return {static_cast<float>(red), static_cast<float>(green), static_cast<float>(blue),
            static_cast<float>(filter), static_cast<float>(transmit)};
  }
};

}  // namespace

ImageSampler::ImageSampler(std::shared_ptr<const Image> image, const ImageSource& source)
    : image_(std::move(image)),
      map_type_(source.map_type),
      interpolation_(source.interpolation),
      once_(source.once),
      premultiplied_(source.premultiplied.value_or(image_->type() == ImageFileType::tiff ||
                                                   image_->type() == ImageFileType::exr)),
      width_(image_->width()),
      height_(image_->height()),
      repeated_width_(width_ * static_cast<double>(static_cast<float>(source.repeat.x))),
      repeated_height_(height_ * static_cast<double>(static_cast<float>(source.repeat.y))),
      offset_(source.offset) {
  if (!image_->is_palette()) {
    for (const auto* list : {&source.filter, &source.transmit}) {
      for (const auto& [index, value] : *list) {
        (list == &source.filter ? added_filter_ : added_transmit_) = value;
      }
    }
    return;
  }
  // Of the palette, the entries themselves change.
  for (int i = 0; i < 256; ++i) {
    const auto& entry = i < image_->palette_size()
                            ? image_->raster().palette[static_cast<size_t>(i)]
                            : std::array<uint16_t, 4>{0, 0, 0, 65535};
    ColorRGBFT c;
    c.transmit = 1 - static_cast<float>(entry[3]) / 65535.0f;
    palette_.push_back(c);
  }
  // In the order of the text.
  const auto set = [&](const std::vector<std::pair<int, float>>& list, float ColorRGBFT::*part) {
    for (const auto& [index, value] : list) {
      if (index == ImageSource::kAllIndices) {
        for (ColorRGBFT& entry : palette_) entry.*part = value;
      } else {
        palette_[static_cast<size_t>(index)].*part = value;
      }
    }
  };
  set(source.filter, &ColorRGBFT::filter);
  set(source.transmit, &ColorRGBFT::transmit);
}

bool ImageSampler::is_opaque() const {
  const bool adds = palette_.empty() && (added_filter_ != 0 || added_transmit_ != 0);
  return is_opaque_before_additions() && !adds;
}

bool ImageSampler::is_opaque_before_additions() const {
  if (once_) return false;
  if (!palette_.empty())
    return std::all_of(palette_.begin(), palette_.begin() + image_->palette_size(),
                       [](const ColorRGBFT& c) { return c.is_opaque(); });
  return image_->is_opaque();
}

bool ImageSampler::locate(const Vec3& p, double& x, double& y) const {
  double u = 0, v = 0;
  const double around = std::sqrt(p.x * p.x + p.z * p.z);
  switch (map_type_) {
    case ImageMapType::planar:
      if (once_ && (p.x < 0 || p.x > 1 || p.y < 0 || p.y > 1)) return false;
      u = std::fmod(p.x * repeated_width_, repeated_width_);
      v = std::fmod(p.y * repeated_height_, repeated_height_);
      break;
    case ImageMapType::spherical: {
      const double distance = length(p);
      if (distance == 0) return false;
      u = (around == 0 ? 0 : direction_fraction(p)) * repeated_width_;
      v = (0.5 + std::asin(std::clamp(p.y / distance, -1.0, 1.0)) / M_PI) * repeated_height_;
      break;
    }
    case ImageMapType::cylindrical:
      if ((once_ && (p.y < 0 || p.y > 1)) || around == 0) return false;
      u = direction_fraction(p) * repeated_width_;
      v = std::fmod(p.y * repeated_height_, repeated_height_);
      break;
    case ImageMapType::toroidal: {
      if (around == 0) return false;
      u = azimuth_fraction(p.x, p.z, around) * repeated_width_;
      const double rho = around - 1, tube = std::sqrt(rho * rho + p.y * p.y);
      double phi = tube == 0 ? 0 : std::acos(-rho / tube);
      if (p.y > 0) phi = 2 * M_PI - phi;
      v = phi / (2 * M_PI) * repeated_height_;
      break;
    }
  }
  u += kEpsilon - width_ * offset_.x;
  v += kEpsilon - height_ * offset_.y;
  if (once_ && (u < 0 || v < 0 || u >= width_ || v >= height_)) return false;
  x = wrap(u, width_);
  y = wrap(-v, height_);
  return true;
}

ColorRGBFT ImageSampler::fetch(int x, int y) const {
  ColorRGBFT c = image_->pixel(x, y);
  if (palette_.empty()) {
    c.filter += added_filter_;
    c.transmit += added_transmit_;
  } else {
    const ColorRGBFT& entry = palette_[static_cast<size_t>(image_->index(x, y))];
    c.filter = entry.filter;
    c.transmit = entry.transmit;
  }
  return c;
}

template <typename Value, typename Fetch>
Value ImageSampler::interpolate(double x, double y, Fetch&& get) const {
  const int width = image_->width(), height = image_->height();
  const auto at = [&](int i, int j) {
    if (once_)
      return get(std::clamp(i, 0, width - 1), std::clamp(j, 0, height - 1));
    return get(wrap_index(i, width), wrap_index(j, height));
  };
  if (interpolation_ == ImageInterpolation::none)
    return at(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
  const double a = x + 0.5, b = y + 0.5;
  const int i = static_cast<int>(a), j = static_cast<int>(b);
  const double f = a - i, g = b - j;
  Value sum{};
  if (interpolation_ == ImageInterpolation::bicubic) {
    const auto weights = [](double t, double* w) {
      const double q = 1 - t;
      w[0] = -0.5 * t * q * q;
      w[1] = 0.5 * q * (q * (3 * t + 1) + 1);
      w[2] = 0.5 * t * (t * (3 * q + 1) + 1);
      w[3] = -0.5 * q * t * t;
    };
    double wx[4], wy[4];
    weights(f, wx);
    weights(g, wy);
    // In povray's order, which decides whether indices come out whole.
    for (int m = 0; m < 4; ++m)
      for (int n = 0; n < 4; ++n)
        sum = sum + at(i - 2 + m, j - 2 + n) * (wx[m] * wy[n]);
    return sum;
  }
  double w[4];
  if (interpolation_ == ImageInterpolation::bilinear) {
    w[0] = f * g, w[1] = (1 - f) * g, w[2] = f * (1 - g), w[3] = (1 - f) * (1 - g);
  } else {
    const double p = 1 - f, q = 1 - g;
    const double squared[4] = {p * p + q * q, f * f + q * q, p * p + g * g, f * f + g * g};
    double total = 0;
    for (int n = 0; n < 4; ++n) {
      if (squared[n] == 0) return at(n % 2 ? i - 1 : i, n / 2 ? j - 1 : j);
      w[n] = 1 / squared[n];
      total += w[n];
    }
    for (double& weight : w) weight /= total;
  }
  for (int n = 0; n < 4; ++n)
    sum = sum + at(n % 2 ? i - 1 : i, n / 2 ? j - 1 : j) * w[n];
  return sum;
}

ColorRGBFT ImageSampler::color(double x, double y) const {
  return interpolate<WideColor>(x, y, [this](int i, int j) { return WideColor(fetch(i, j)); })
      .narrow();
}

int ImageSampler::index(double x, double y) const {
  // Without a palette every index is -1, and the interpolated one 0 where the weights sum to
  // less than 1.
  const bool has_indices = image_->is_palette();
  return static_cast<int>(interpolate<double>(x, y, [&](int i, int j) {
    return has_indices ? static_cast<double>(image_->index(i, j)) : -1.0;
  }));
}

}  // namespace durer
