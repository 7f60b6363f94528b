// spiral1, spiral2, quilted, ripples, waves.
//
//   spiral1 N, spiral2 N   N: number of arms
//   quilted                control0 F (1), control1 F (1)
//   ripples, waves         sums over number_of_waves sources
//
//   pigment { spiral2 5 color_map { [0 rgb 0] [1 rgb 1] } }
//
// Source: spec/textures.md 2.8, 6.
#include <cmath>
#include <cstdint>
#include <vector>

#include "tracer/patterns/noise.h"
#include "tracer/patterns/pattern_factories.h"
#include "tracer/patterns/quilt.h"
#include "tracer/patterns/wave_sources.h"

namespace durer {
namespace {

double triangle(double v) {
  double f = v;
  if (f < 0) f += 1 + std::floor(std::abs(f));
  f -= std::floor(f);
  return f < 0.5 ? 2 * f : 2 * (1 - f);
}

class Spiral : public BasePattern {
 public:
  Spiral(const PatternNode& node, const PatternSettings& settings, bool second)
      : arms_(node.arms),
        second_(second),
        turbulent_(node.has_turbulence),
        turbulence_(node.turbulence),
        generator_(noise_generator_of(node, settings)) {}

  double base_value(const Vec3& p, const PatternContext&) const override {
    const double radius = std::sqrt(p.x * p.x + p.y * p.y);
    double phi = 0;
    if (radius != 0) {
      const double angle = std::asin(p.y / radius);
      phi = p.x >= 0 ? M_PI / 2 + angle : 3 * M_PI / 2 - angle;
    }
    double v = p.z + radius + arms_ * phi / (2 * M_PI);
    if (turbulent_) {
      v += turbulence_.strength.x * turbulence(p, turbulence_.octaves, turbulence_.omega,
                                               turbulence_.lambda, generator_);
    }
    return second_ ? triangle(radius) + triangle(v) : v;
  }

 private:
  int arms_;
  bool second_, turbulent_;
  Turbulence turbulence_;
  int generator_;
};

class Quilted : public BasePattern {
 public:
  explicit Quilted(const PatternNode& node)
      : control0_(node.quilt_control0), control1_(node.quilt_control1) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    const Vec3 q = quilt(p, control0_, control1_);
    return (std::abs(q.x) + std::abs(q.y) + std::abs(q.z)) / 3;
  }
  // t is at most half the cube's diagonal; t·u² and t²·u are at most 4/27, the mean of |w| 1/2.
  ValueRange base_range(const Bounds&) const override {
    const double c0 = control0_, c1 = control1_;
    const double low = 0.58 * (0.4445 * std::min(c0, 0.0) + 0.4445 * std::min(c1, 0.0));
    const double high = 0.58 * (0.65 + 0.4445 * std::max(c0, 0.0) + 0.4445 * std::max(c1, 0.0));
    return {0, std::max(-low, high)};
  }

 private:
  double control0_, control1_;
};

class RippleOrWave : public BasePattern {
 public:
  RippleOrWave(const PatternNode& node, const PatternSettings& settings, bool waves)
      : sources_(wave_sources(settings.number_of_waves)),
        frequency_(node.frequency),
        phase_(node.phase),
        waves_(waves) {}

  double base_value(const Vec3& p, const PatternContext&) const override {
    double sum = 0;
    for (const WaveSource& source : sources_) {
      double distance = length(p - source.center);
      if (distance == 0) distance = 1;
      if (waves_) {
        sum += cycle(distance * frequency_ * source.frequency + phase_) / source.frequency;
      } else {
        sum += cycle(distance * frequency_ + phase_);
      }
    }
    const double mean = sum / static_cast<double>(sources_.size());
    return waves_ ? 0.2 * (2.5 + mean) : 0.5 * (1 + mean);
  }
  ValueRange base_range(const Bounds&) const override {
    if (!waves_) return {0, 1};
    double most = 0;
    for (const WaveSource& source : sources_) most += 1 / source.frequency;
    most /= static_cast<double>(sources_.size());
    return {0.2 * (2.5 - most), 0.2 * (2.5 + most)};
  }

 private:
  std::vector<WaveSource> sources_;
  double frequency_, phase_;
  bool waves_;
};

}  // namespace

std::vector<WaveSource> wave_sources(int count) {
  std::vector<WaveSource> sources;
  uint32_t state = static_cast<uint32_t>(-560851967);
  for (int i = 0; i < count; ++i) {
    state = state * 1812433253u + 12345u;
    const double drawn = static_cast<double>((state >> 16) & 0x7fff);
    sources.push_back({normalize_or_zero(vector_noise({static_cast<double>(i), 0, 0})),
                       drawn * 0.000030518509476 + 0.01});
  }
  return sources;
}

std::unique_ptr<const BasePattern> make_spiral1(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Spiral>(n, s, false);
}
std::unique_ptr<const BasePattern> make_spiral2(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Spiral>(n, s, true);
}
std::unique_ptr<const BasePattern> make_quilted(const PatternNode& n, const PatternSettings&) {
  return std::make_unique<Quilted>(n);
}
std::unique_ptr<const BasePattern> make_ripples(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<RippleOrWave>(n, s, false);
}
std::unique_ptr<const BasePattern> make_waves(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<RippleOrWave>(n, s, true);
}

}  // namespace durer
