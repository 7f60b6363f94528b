// Refraction and straight transmission (spec/shading.md 11.2-11.6).
#include <cmath>

#include "tracer/shading/dispersion.h"
#include "tracer/shading/whitted.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;
constexpr uint64_t kEventTransmission = 1001;

// Snell's law: eta = ior before / ior behind, n facing the ray. False: total internal reflection.
// The direction is left as long as rounding makes it, as povray's is (measured on povray 3.7).
bool refracted(const Vec3& d, Vec3 n, double eta, Vec3& out) {
  double c = -dot(d, n);
  if (c < 0) {
    n = -n;
    c = -c;
  }
  const double t = 1 + eta * eta * (c * c - 1);
  if (t < 0) return false;
  out = eta * d + (eta * c - std::sqrt(t)) * n;
  return true;
}

}  // namespace

bool WhittedIntegrator::transmit_ray(const TracedRay& ray, const SurfaceHit& hit,
                                     const TextureLayer& top_layer, const Vec3& top_normal,
                                     float weight, const RGB& filter, bool filtered,
                                     RayCounts& counts, RGB& color, float& transmit) const {
  const auto& interiors = scene_.world->interiors();
  const WorldInterior& interior = hit.interior;
  const float own_ior = interior.ior;

  // What the ray is in behind the surface, and the ratio of the indices. Between two interiors that is
  // a quotient of single precision, which moves what is seen by 1e-8 (measured on povray 3.7).
  TracedRay next = ray;
  next.beam = nullptr;
  InteriorList& behind = next.interiors;
  double ratio = 1, dispersion = 1;
  int samples = interior.dispersion_samples;
  const int position = ray.interiors.find(hit.surface.object->interior);
  if (position < 0) {
    if (behind.empty()) {
      ratio = 1 / static_cast<double>(own_ior);
      dispersion = 1 / static_cast<double>(interior.dispersion);
    } else {
      ratio = static_cast<double>(interiors[behind.last()].ior / own_ior);
      dispersion =
          static_cast<double>(interiors[behind.last()].dispersion / interior.dispersion);
    }
    behind.append(hit.surface.object->interior);
  } else {
    const bool was_last = position == ray.interiors.size() - 1;
    behind.remove_at(position);
    if (was_last) {
      float quotient = own_ior, dispersion_quotient = interior.dispersion;
      if (!behind.empty()) {
        const WorldInterior& outer = interiors[behind.last()];
        quotient /= outer.ior;
        dispersion_quotient /= outer.dispersion;
        samples = std::max(samples, outer.dispersion_samples);
      }
      ratio = static_cast<double>(quotient);
      dispersion = static_cast<double>(dispersion_quotient);
    }
  }

  // Light fades over the way inside this object, and `refraction` dims it at each surface.
  RGB attenuation(1.0f);
  if (position >= 0 && interior.node && std::abs(interior.node->fade_distance) > kEpsilon) {
    attenuation = interior_fade(*interior.node, hit.depth);
  }
  attenuation *= interior.refraction;
  const RGB passed = filtered ? attenuation * filter : attenuation;

  const bool straight = std::abs(ratio - 1) < kEpsilon && std::abs(dispersion - 1) < kEpsilon;
  ++counts.refracted;
  next.origin = hit.surface.point;
  next.max_depth = kFarAway;
  next.kind.primary = false;
  next.spawned_as = RayKind::refracted;
  next.events.append(PathEvents::Event::specular);
  next.weight = weight;
  next.path = extend_path(ray.path, kEventTransmission);
  if (straight) {
    // Straight on counts as one level, however many surfaces follow.
    if (ray.level + 1 >= scene_.scene.settings.max_trace_level) return false;
    const RayResult seen = trace(next, counts);
    color += passed * seen.color;
    transmit = attenuation.grey() * seen.transmit;
    return false;
  }

  if (std::abs(dispersion - 1) > kEpsilon && !ray.band.is_monochromatic()) {
    color += passed * refract_bands(ray, next, hit, top_layer, top_normal, ratio, dispersion,
                                    samples, counts);
    return false;
  }
  const double band_ratio = ray.band.is_monochromatic()
                                ? ratio * std::pow(dispersion, -(ray.band.wavelength - 555) / 350)
                                : ratio;
  if (!refracted(ray.direction, top_normal, band_ratio, next.direction)) {
    ++counts.total_internal;
    color += attenuation * reflect(ray, hit, top_normal, top_layer, weight, counts);
    return true;
  }
  next.level = ray.level + 1;
  const RayResult seen = trace(next, counts);
  color += passed * seen.color;
  transmit = attenuation.grey() * seen.transmit;
  return false;
}

RGB WhittedIntegrator::refract_bands(const TracedRay& ray, const TracedRay& next,
                                     const SurfaceHit& hit, const TextureLayer& top_layer,
                                     const Vec3& top_normal, double ratio, double dispersion,
                                     int samples, RayCounts& counts) const {
  RGB sum(0.0f);
  // Widths and centres are rounded to single precision, as povray's are (measured on povray 3.7).
  const auto width = static_cast<double>(350.0f / static_cast<float>(samples));
  for (int i = 0; i < samples; ++i) {
    TracedRay band = next;
    band.level = ray.level + 1;
    band.path = extend_path(ray.path, kEventTransmission + 1 + static_cast<uint64_t>(i));
    const auto center = static_cast<float>(380 + width * (i + 0.5));
    band.band = {static_cast<double>(center), width};
    const double band_ratio = ratio * std::pow(dispersion, -(band.band.wavelength - 555) / 350);
    const RGB seen = refracted(ray.direction, top_normal, band_ratio, band.direction)
                         ? trace(band, counts).color
                         : reflect(ray, hit, top_normal, top_layer, next.weight, counts);
    sum += band_hue(band.band.wavelength, width, samples) * seen;
  }
  return sum * (1.0f / static_cast<float>(samples));
}

}  // namespace durer
