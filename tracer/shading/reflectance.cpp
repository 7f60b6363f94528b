#include "tracer/shading/reflectance.h"

#include "tracer/math/power.h"
#include "tracer/patterns/noise.h"

namespace durer {

Reflectivity reflectivity(const FinishNode& finish, double cosine, double relative_ior,
                          const RGB& pigment) {
  constexpr double kEpsilon = 1e-10;
  const RGB& low = finish.reflection_min;
  const RGB& high = finish.reflection_max;
  Reflectivity result;
  if (finish.reflection_fresnel) {
    const double k = cosine;
    const double s = relative_ior * relative_ior + k * k - 1;
    if (s > 0) {
      const double g = std::sqrt(s);
      const double a = (g - k) / (g + k);
      const double b = (k * (g + k) - 1) / (k * (g - k) + 1);
      const double f = std::clamp(0.5 * a * a * (1 + b * b), 0.0, 1.0);
      result.color = high.times(f) + low.times(1 - f);
    } else {
      result.color = high;
    }
    result.weight = result.color.max_component();
  } else {
    const double grazing =
        finish.reflection_falloff == 1
            ? 1 - cosine
            : power(1 - cosine, static_cast<double>(finish.reflection_falloff));
    if (std::abs(grazing) < kEpsilon) {
      result.color = low;
    } else if (std::abs(grazing - 1) < kEpsilon) {
      result.color = high;
    } else {
      result.color = high.times(grazing) + low.times(1 - grazing);
    }
    result.weight = std::max(low.max_component(), high.max_component());
  }
  if (finish.reflection_metallic != 0 && !result.color.is_black()) {
    const double x = std::abs(std::acos(std::clamp(cosine, -1.0, 1.0))) / (M_PI / 2);
    const float share = finish.reflection_metallic * (1 - metallic_tint_share(x));
    result.color *= RGB(1.0f) + (pigment - RGB(1.0f)) * share;
  }
  return result;
}

RGB irid_factor(const Irid& irid, const Vec3& point, double cosine_sum,
                const GlobalSettings& settings) {
  double thickness = irid.thickness;
  if (irid.turbulence != 0) {
    const double noise = turbulence(point, 5, 0.5, 2, settings.noise_generator);
    thickness *= 1 + irid.turbulence * (2 * noise - 1);
  }
  const RGB& wavelength = settings.irid_wavelength;
  const double path = 2 * M_PI * thickness * cosine_sum;
  auto channel = [&](float lambda) {
    return static_cast<float>(1 + irid.amount * std::cos(path / lambda));
  };
  return {channel(wavelength.red), channel(wavelength.green), channel(wavelength.blue)};
}

}  // namespace durer
