// internal(n): the noises and noise fractals, and the closed formulas of internal_surfaces.cpp
// (spec/functions.md 4).
#include "tracer/functions/internal_function.h"

#include <algorithm>
#include <cmath>

#include "tracer/functions/internal_surfaces.h"
#include "tracer/patterns/noise.h"

namespace durer {
namespace {

class SurfaceFunction final : public CompiledFunction {
 public:
  explicit SurfaceFunction(const InternalSurface& surface)
      : CompiledFunction(FunctionKind::internal, 3 + surface.extra_parameters, 1),
        formula_(surface.formula) {}
  void evaluate(const double* a, double* result) const override { *result = formula_(a); }
  double scalar(const double* a) const override { return formula_(a); }

 private:
  SurfaceFormula formula_;
};

class NoiseFunction final : public CompiledFunction {
 public:
  NoiseFunction(int number, int extra_parameters, std::shared_ptr<const FieldSettings> settings)
      : CompiledFunction(FunctionKind::internal, 3 + extra_parameters, 1),
        number_(number), settings_(std::move(settings)) {}
  void evaluate(const double* a, double* result) const override { *result = scalar(a); }
  double scalar(const double* a) const override;
  ValueRange range(const Bounds& box) const override {
    return number_ == kNoise ? ValueRange{0, 1} : CompiledFunction::range(box);
  }

  // H and L of the call whose weights internal(59) keeps (4.5).
  void remember_site(double h, double lacunarity) const {
    if (!site_.known) site_ = {true, h, lacunarity};
  }

  static constexpr int kHeteroFractal = 29, kRidge = 58, kRidgedFractal = 59, kNoise = 76,
                       kGeneratedNoise = 78;
  int number() const { return number_; }

 private:
  struct Weights {
    bool known = false;
    double h = 0, lacunarity = 0;
  };
  double ridged(const double* a) const;

  int number_;
  std::shared_ptr<const FieldSettings> settings_;
  // Written only while the scene is parsed, by one thread; constant when rays fly.
  mutable Weights first_call_, site_;
};

// trunc(p) AND 3, 0 acts as 1 (4.3).
int generator_of(double parameter) {
  const int n = static_cast<int>(std::clamp(parameter, -2147483648.0, 2147483647.0)) & 3;
  return n == 0 ? 1 : n;
}

double signed_noise(const Vec3& p, int generator) { return 2 * noise(p, generator) - 1; }

double hetero_fractal(const double* a) {
  Vec3 p(a[0], a[1], a[2]);
  const double lacunarity = a[4], octaves = a[5], offset = a[6];
  const int times = static_cast<int>(std::clamp(a[7], 0.0, 1e6));
  const int generator = generator_of(a[8]);
  const double step = std::pow(lacunarity, -a[3]);
  double sum = signed_noise(p, generator) + offset;
  p *= lacunarity;
  double weight = step;
  for (int i = 1; i < octaves; ++i) {
    double increment = (signed_noise(p, generator) + offset) * weight;
    for (int k = 0; k < times; ++k) increment *= sum;
    sum += increment;
    p *= lacunarity;
    weight *= step;
  }
  const double remainder = octaves - std::trunc(octaves);
  if (remainder != 0) sum += remainder * (signed_noise(p, generator) + offset) * weight * sum;
  return sum;
}

double ridge(const double* a) {
  const Vec3 p(a[0], a[1], a[2]);
  const double lambda = a[3], octaves = a[4], omega = a[5], offset = a[6], crest = a[7];
  const int generator = generator_of(a[8]);
  const double k = 1 / std::max(crest, 1 - crest), scale = 1 / std::max(offset, 1 - offset);
  const auto octave = [&](const Vec3& q) {
    return std::abs(noise(q, generator) - crest) * k - offset;
  };
  const int whole = static_cast<int>(std::clamp(octaves, -1e6, 1e6));
  double value = octave(p), total = 1, frequency = lambda, amplitude = omega;
  for (int i = 2; i <= whole; ++i) {
    value += amplitude * octave(frequency * p);
    total += amplitude;
    frequency *= lambda;
    amplitude *= omega;
  }
  if (octaves != whole) {
    value += amplitude * octave(frequency * p) * (octaves - whole);
    total += amplitude * (octaves - whole);
  }
  return value * scale / total;
}

double NoiseFunction::ridged(const double* a) const {
  Vec3 p(a[0], a[1], a[2]);
  const double lacunarity = a[4], octaves = a[5], offset = a[6], gain = a[7];
  const int generator = generator_of(a[8]);

  // The weights come from the first call of this identifier. Once rays fly the first call would
  // depend on threads: the first call in the text stands for it.
  if (!settings_->frozen && !first_call_.known) first_call_ = {true, a[3], lacunarity};
  const Weights own{true, a[3], lacunarity};
  const Weights& weights = first_call_.known ? first_call_ : site_.known ? site_ : own;

  double signal = offset - std::abs(signed_noise(p, generator));
  signal *= signal;
  double result = signal, frequency = 1;
  for (int i = 1; i < octaves; ++i) {
    frequency *= weights.lacunarity;
    p *= lacunarity;
    const double weight = std::clamp(signal * gain, 0.0, 1.0);
    signal = offset - std::abs(signed_noise(p, generator));
    signal *= signal;
    signal *= weight;
    result += signal * std::pow(frequency, -weights.h);
  }
  return result;
}

double NoiseFunction::scalar(const double* a) const {
  switch (number_) {
    case kHeteroFractal: return hetero_fractal(a);
    case kRidge: return ridge(a);
    case kRidgedFractal: return ridged(a);
    case kGeneratedNoise: return noise({a[0], a[1], a[2]}, generator_of(a[3]));
    default: return noise({a[0], a[1], a[2]}, settings_->noise_generator);
  }
}

}  // namespace

FunctionHandle make_internal_function(int number, std::shared_ptr<const FieldSettings> settings) {
  if (const InternalSurface* surface = find_internal_surface(number))
    return std::make_shared<SurfaceFunction>(*surface);
  switch (number) {
    case NoiseFunction::kHeteroFractal:
    case NoiseFunction::kRidge:
    case NoiseFunction::kRidgedFractal:
      return std::make_shared<NoiseFunction>(number, 6, std::move(settings));
    case NoiseFunction::kNoise:
      return std::make_shared<NoiseFunction>(number, 0, std::move(settings));
    case NoiseFunction::kGeneratedNoise:
      return std::make_shared<NoiseFunction>(number, 1, std::move(settings));
    default: return nullptr;
  }
}

void remember_fractal_use(const CompiledFunction& function, double h, double lacunarity) {
  const auto* noise_function = dynamic_cast<const NoiseFunction*>(&function);
  if (noise_function && noise_function->number() == NoiseFunction::kRidgedFractal)
    noise_function->remember_site(h, lacunarity);
}

}  // namespace durer
