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

// Bounds of scalar turbulence (spec/textures.md 3).
ValueRange turbulence_range(const Turbulence& t, int generator) {
  double low = 0, high = 1, amplitude = 1;
  for (int i = 1; i < t.octaves; ++i) {
    amplitude *= static_cast<double>(t.omega);
    const double a = amplitude * (generator == 1 ? 0.0 : -0.5);
    const double b = amplitude * (generator == 1 ? 1.0 : 1.5);
    low += std::min(a, b);
    high += std::max(a, b);
  }
  return {low, high};
}

class NoisePattern : public BasePattern {
 public:
  NoisePattern(const PatternNode& node, const PatternSettings& settings)
      : generator_(noise_generator_of(node, settings)), turbulence_(node.turbulence) {}

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
    return granite(p, generator_);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }
};

class Wrinkles : public NoisePattern {
 public:
  using NoisePattern::NoisePattern;
  double base_value(const Vec3& p, const PatternContext&) const override {
    return wrinkles(p, generator_);
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

  ValueRange base_range(const Bounds& box) const override {
    if (!turbulent_) return {box.min.x, box.max.x};
    const ValueRange t = turbulence_range(turbulence_, generator_);
    const double a = turbulence_.strength.x * t.lower, b = turbulence_.strength.x * t.upper;
    return {box.min.x + std::min(a, b), box.max.x + std::max(a, b)};
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
      const Vec2 d =
          vector_turbulence_xy(p, turbulence_.octaves, turbulence_.omega, turbulence_.lambda);
      a = cycle((p.x + d.x) * turbulence_.strength.x);
      b = cycle((p.y + d.y) * turbulence_.strength.y);
    }
    return std::sqrt((p.x + a) * (p.x + a) + (p.y + b) * (p.y + b));
  }
  ValueRange base_range(const Bounds& box) const override {
    // The slot shifts x and y by at most 1.
    const double slack = turbulent_ ? 1 : 0;
    double near = 0, far = 0;
    for (int axis = 0; axis < 2; ++axis) {
      const double low = box.min[axis] - slack, high = box.max[axis] + slack;
      const double least = std::max({0.0, low, -high});
      const double most = std::max(std::abs(low), std::abs(high));
      near += least * least;
      far += most * most;
    }
    return {std::sqrt(near), std::sqrt(far)};
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
