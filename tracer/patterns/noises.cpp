// bozo, spotted, bumps, dents, granite, wrinkles, agate, marble, wood: patterns made of noise.
//
//   agate_turb F   strength of agate's own turbulence   default 1
//
//   pigment { marble turbulence 0.5 color_map { [0 rgb 1] [1 rgb 0] } }
//
// Source: spec/textures.md 6.
#include "tracer/patterns/noise.h"

#include <algorithm>
#include <cmath>

#include "tracer/patterns/pattern_factories.h"
#include "tracer/patterns/wave_sources.h"

namespace durer {
namespace {

int generator_of(const PatternNode& node, const PatternSettings& settings) {
  return node.noise_generator != 0 ? node.noise_generator : settings.noise_generator;
}

class NoisePattern : public BasePattern {
 public:
  NoisePattern(const PatternNode& node, const PatternSettings& settings)
      : generator_(generator_of(node, settings)), turbulence_(node.turbulence) {}

 protected:
  int generator_;
  Turbulence turbulence_;
};

class Bozo : public NoisePattern {
 public:
  using NoisePattern::NoisePattern;
  double base_value(const Vec3& p, const PatternContext&) const override {
    return noise(p, generator_);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }
};

class Dents : public NoisePattern {
 public:
  using NoisePattern::NoisePattern;
  double base_value(const Vec3& p, const PatternContext&) const override {
    const double n = noise(p, generator_);
    return n * n * n;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }
};

class Granite : public NoisePattern {
 public:
  using NoisePattern::NoisePattern;
  double base_value(const Vec3& p, const PatternContext&) const override {
    double sum = 0, frequency = 4, divisor = 1;
    for (int i = 0; i < 6; ++i) {
      const double n = noise(p * frequency, generator_);
      const double a =
          generator_ == 1 ? std::abs(0.5 - n) : std::min(0.5, std::abs(1.0 - 2.0 * n));
      sum += a / divisor;
      frequency *= 2;
      divisor *= 2;
    }
    return sum;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }
};

class Wrinkles : public NoisePattern {
 public:
  using NoisePattern::NoisePattern;
  double base_value(const Vec3& p, const PatternContext&) const override {
    double sum = 0, scale = 1;
    for (int i = 0; i < 10; ++i) {
      double n = noise(p * scale, generator_);
      if (generator_ > 1) n = std::clamp(2 * n - 0.5, 0.0, 1.0);
      sum += n / scale;
      scale *= 2;
    }
    return sum / 2;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }
};

class Agate : public NoisePattern {
 public:
  Agate(const PatternNode& node, const PatternSettings& settings)
      : NoisePattern(node, settings), strength_(node.agate_turbulence) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    const double t = turbulence(p, turbulence_.octaves, turbulence_.omega, turbulence_.lambda,
                                generator_);
    const double y = 0.5 * (1 + cycle(1.3 * strength_ * t + 1.1 * p.z));
    if (y < 0) return 0;
    return std::pow(std::min(y, 1.0), 0.77);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  double strength_;
};

class Marble : public NoisePattern {
 public:
  Marble(const PatternNode& node, const PatternSettings& settings)
      : NoisePattern(node, settings), turbulent_(node.has_turbulence) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    if (!turbulent_) return p.x;
    return p.x + turbulence_.strength.x * turbulence(p, turbulence_.octaves, turbulence_.omega,
                                                     turbulence_.lambda, generator_);
  }

 private:
  bool turbulent_;
};

class Wood : public NoisePattern {
 public:
  Wood(const PatternNode& node, const PatternSettings& settings)
      : NoisePattern(node, settings), turbulent_(node.has_turbulence) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    double a = 0, b = 0;
    if (turbulent_) {
      const Vec3 d =
          vector_turbulence(p, turbulence_.octaves, turbulence_.omega, turbulence_.lambda);
      a = cycle((p.x + d.x) * turbulence_.strength.x);
      b = cycle((p.y + d.y) * turbulence_.strength.y);
    }
    return std::sqrt((p.x + a) * (p.x + a) + (p.y + b) * (p.y + b));
  }

 private:
  bool turbulent_;
};

}  // namespace

std::unique_ptr<const BasePattern> make_bozo(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Bozo>(n, s);
}
std::unique_ptr<const BasePattern> make_dents(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Dents>(n, s);
}
std::unique_ptr<const BasePattern> make_granite(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Granite>(n, s);
}
std::unique_ptr<const BasePattern> make_wrinkles(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Wrinkles>(n, s);
}
std::unique_ptr<const BasePattern> make_agate(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Agate>(n, s);
}
std::unique_ptr<const BasePattern> make_marble(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Marble>(n, s);
}
std::unique_ptr<const BasePattern> make_wood(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Wood>(n, s);
}

}  // namespace durer
