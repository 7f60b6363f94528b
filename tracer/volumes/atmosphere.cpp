#include "tracer/volumes/atmosphere.h"

#include <algorithm>
#include <cmath>

#include "tracer/patterns/noise.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

ColorRGBFT look_up(const ColorMap& map, double value) {
  const auto& entries = map.entries;
  if (value >= entries.back().position) return entries.back().item;
  size_t upper = 0;
  while (value > entries[upper].position) ++upper;
  if (upper == 0) return entries[0].item;
  const auto& low = entries[upper - 1];
  const auto& high = entries[upper];
  const float share = static_cast<float>((value - low.position) / (high.position - low.position));
  return low.item * (1 - share) + high.item * share;
}

// Mean density of ground fog between two heights, in units of the fog's altitude.
double mean_ground_density(double start, double end) {
  if (start <= 0 && end <= 0) return 1;
  if (start <= 0) return (std::atan(end) - start) / (end - start);
  if (end <= 0) return (std::atan(start) - end) / (start - end);
  // Neither does fog of altitude 0 thicken an infinite way.
  if (!(std::abs(start - end) > kEpsilon)) return 1 / (start * start + 1);
  return (std::atan(start) - std::atan(end)) / (start - end);
}

}  // namespace

Atmosphere::Atmosphere(const Scene& scene, const TextureSettings& settings, bool output_alpha)
    : new_rules_(scene.effective_version >= 370),
      output_alpha_(output_alpha),
      noise_generator_(scene.settings.noise_generator),
      background_(scene.background) {
  if (scene.sky_sphere) {
    for (const auto& pigment : scene.sky_sphere->pigments) {
      sky_pigments_.push_back(compile_pigment(*pigment, settings));
    }
    sky_transform_ = scene.sky_sphere->transform;
    sky_emission_ = scene.sky_sphere->emission;
  }
  for (const FogNode& fog : scene.fogs) {
    if (std::abs(fog.distance) <= kEpsilon) continue;
    fogs_.push_back(fog);
    fogs_.back().up = fog.up / length(fog.up);  // of zero: not a number, as in POV-Ray
  }
  for (const RainbowNode& node : scene.rainbows) {
    if (node.width == 0 || node.distance == 0 || !node.color_map) continue;
    Rainbow rainbow{node, {}, {}, 0, 0, 0, 0};
    rainbow.direction = normalize_or_zero(node.direction);
    const Vec3 right = normalize_or_zero(cross(normalize_or_zero(node.up), rainbow.direction));
    rainbow.up = normalize_or_zero(cross(rainbow.direction, right));
    const double degree = M_PI / 180;
    rainbow.width = node.width * degree;
    rainbow.start_angle = node.angle * degree - rainbow.width / 2;
    rainbow.arc = node.arc_angle * degree / 2;
    rainbow.falloff = node.falloff_angle * degree / 2;
    rainbows_.push_back(rainbow);
  }
}

void Atmosphere::background(const Vec3& direction, bool alpha_background, RGB& color,
                            float& transmit) const {
  const bool alpha = output_alpha_ && alpha_background;
  if (!new_rules_) {
    if (alpha) {
      color = RGB(0.0f);
      transmit = 1;
      return;
    }
    old_background(direction, color, transmit);
    return;
  }
  RGB sum(0.0f), filter(1.0f);
  const Vec3 point = sky_transform_.inverse_point(direction);
  const TextureContext context;
  for (auto it = sky_pigments_.rbegin(); it != sky_pigments_.rend(); ++it) {
    ColorRGBFT c;
    (*it)->evaluate(point, context, c);
    sum += c.rgb() * filter * sky_emission_ * (1 - c.filter - c.transmit);
    filter *= c.rgb() * c.filter + RGB(c.transmit);
  }
  ColorRGBFT b = background_;
  if (!alpha) b.filter = b.transmit = 0;
  sum += b.rgb() * filter * (1 - b.filter - b.transmit);
  filter *= b.rgb() * b.filter + RGB(b.transmit);
  color = sum;
  transmit = std::min(1.0f, std::abs(filter.grey()));
}

// The composition of versions before 3.7 (spec/shading.md 13.1).
void Atmosphere::old_background(const Vec3& direction, RGB& color, float& transmit) const {
  const RGB behind = background_.rgb();
  transmit = 0;
  if (sky_pigments_.empty()) {
    color = behind;
    return;
  }
  RGB sum(0.0f);
  float share = 1;
  ColorRGBFT product{1, 1, 1, 1, 1};
  const Vec3 point = sky_transform_.inverse_point(direction);
  const TextureContext context;
  for (auto it = sky_pigments_.rbegin(); it != sky_pigments_.rend(); ++it) {
    ColorRGBFT c;
    (*it)->evaluate(point, context, c);
    sum += c.rgb() * (share * (1 - c.filter - c.transmit));
    product = {product.red * c.red, product.green * c.green, product.blue * c.blue,
               product.filter * c.filter, product.transmit * c.transmit};
    share = std::abs(product.filter) + std::abs(product.transmit);
  }
  color = sum * sky_emission_ + behind * (product.rgb() * product.filter + RGB(product.transmit));
}

void Atmosphere::apply_fog(const Vec3& origin, const Vec3& direction, double depth, bool shadow,
                           RGB& color, float& transmit) const {
  if (fogs_.empty()) return;
  RGB attenuation(1.0f), added(0.0f);
  for (const FogNode& fog : fogs_) {
    double density = 1;
    if (fog.type == 2) {
      const double start = (dot(origin, fog.up) - fog.offset) / fog.altitude;
      const double end = (dot(origin + depth * direction, fog.up) - fog.offset) / fog.altitude;
      density = mean_ground_density(start, end);
    }
    double length = depth;
    if (fog.has_turbulence) {
      const Turbulence& t = fog.turbulence;
      const Vec3 middle = (origin + 0.5 * depth * direction) * t.strength;
      const double thinning = turbulence(middle, t.octaves, static_cast<double>(t.omega),
                                         static_cast<double>(t.lambda), noise_generator_);
      length *= 1 - std::exp(-depth / fog.distance) * std::min(1.0, thinning * fog.turbulence_depth);
    }
    float a = static_cast<float>(std::exp(-length * density / fog.distance));
    a = std::max(a, fog.color.transmit);
    attenuation *= (RGB(1 - fog.color.filter) + fog.color.rgb() * fog.color.filter) * a;
    if (!shadow) added += fog.color.rgb() * (1 - a);
  }
  color = added + attenuation * color;
  transmit *= attenuation.grey();
}

void Atmosphere::apply_rainbow(const Vec3& direction, double depth, double jitter, RGB& color,
                               float& transmit) const {
  RGB sum(0.0f);
  float transmit_product = 1;
  int met = 0;
  for (const Rainbow& rainbow : rainbows_) {
    const double forward = dot(direction, rainbow.direction);
    if (forward < 0) continue;
    const Vec3 right = cross(rainbow.up, rainbow.direction);
    const double x = dot(direction, right), y = dot(direction, rainbow.up);
    const double radius = std::sqrt(x * x + y * y);
    const double around = std::abs(std::acos(std::clamp(radius > 0 ? y / radius : 1.0, -1.0, 1.0)));
    if (around > rainbow.arc) continue;
    double index = (std::acos(std::min(1.0, forward)) - rainbow.start_angle) / rainbow.width;
    if (rainbow.node.jitter > 0) index += (2 * jitter - 1) * rainbow.node.jitter;
    if (index < 0 || index > 1 - kEpsilon) continue;
    const ColorRGBFT c = look_up(*rainbow.node.color_map, index);
    float fade = 0;
    if (around > rainbow.falloff && rainbow.arc > rainbow.falloff) {
      const double z = (around - rainbow.falloff) / (rainbow.arc - rainbow.falloff);
      fade = static_cast<float>((3 - 2 * z) * z * z);
    }
    const float k = std::max(static_cast<float>(std::exp(-depth / rainbow.node.distance)),
                             fade * (1 - c.transmit) + c.transmit);
    const float tint = c.filter * (1 - k);
    sum += color * (RGB(1 - tint) + c.rgb() * tint) * k + c.rgb() * (1 - k);
    transmit_product *= k * c.transmit;
    ++met;
  }
  if (met == 0) return;
  color = sum * (1.0f / static_cast<float>(met));
  transmit *= transmit_product;
}

}  // namespace durer
