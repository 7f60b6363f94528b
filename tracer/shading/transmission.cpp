// Refraction and straight transmission (spec/shading.md 11.2-11.6).
#include <cmath>

#include "tracer/shading/dispersion.h"
#include "tracer/shading/whitted.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;
constexpr uint64_t kEventTransmission = 1001;

// Snell's law: eta = ior before / ior behind, n facing the ray. False: total internal reflection.
bool refracted(const Vec3& d, Vec3 n, double eta, Vec3& out) {
  double c = -dot(d, n);
  if (c < 0) {
    n = -n;
    c = -c;
  }
  const double t = 1 + eta * eta * (c * c - 1);
  if (t < 0) return false;
  out = unit_or_zero(eta * d + (eta * c - std::sqrt(t)) * n);
  return true;
}

}  // namespace

bool WhittedIntegrator::transmit_ray(const TracedRay& ray, const SurfaceHit& hit,
                                     const TextureLayer& top_layer, const Vec3& top_normal,
                                     float weight, const RGB& filter, bool filtered,
                                     RayCounts& counts, RGB& color, float& transmit) const {
  const auto& interiors = scene_.world->interiors();
  const WorldInterior& interior = hit.interior;
  const double own_ior = interior.ior;

  // What the ray is in behind the surface, and the ratio of the indices.
  TracedRay next = ray;
  next.beam = nullptr;
  InteriorList& behind = next.interiors;
  double ratio = 1, dispersion = 1;
  int samples = interior.dispersion_samples;
  const int position = ray.interiors.find(hit.surface.object->interior);
  if (position < 0) {
    if (behind.empty()) {
      ratio = 1 / own_ior;
      dispersion = 1 / interior.dispersion;
    } else {
      ratio = interiors[behind.last()].ior / own_ior;
      dispersion = interiors[behind.last()].dispersion / interior.dispersion;
    }
    behind.append(hit.surface.object->interior);
  } else {
    const bool was_last = position == ray.interiors.size() - 1;
    behind.remove_at(position);
    if (was_last) {
      ratio = behind.empty() ? own_ior : own_ior / interiors[behind.last()].ior;
      dispersion = behind.empty() ? interior.dispersion
                                  : interior.dispersion / interiors[behind.last()].dispersion;
      if (!behind.empty()) {
        samples = std::max(samples, interiors[behind.last()].dispersion_samples);
      }
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
  if (ray.band.is_monochromatic()) {
    ratio *= std::pow(dispersion, -(ray.band.wavelength - 555) / 350);
  }
  if (!refracted(ray.direction, top_normal, ratio, next.direction)) {
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
  const double width = 350.0 / samples;
  for (int i = 0; i < samples; ++i) {
    TracedRay band = next;
    band.level = ray.level + 1;
    band.path = extend_path(ray.path, kEventTransmission + 1 + static_cast<uint64_t>(i));
    band.band = {380 + width * (i + 0.5), width};
    const double band_ratio = ratio * std::pow(dispersion, -(band.band.wavelength - 555) / 350);
    const RGB seen = refracted(ray.direction, top_normal, band_ratio, band.direction)
                         ? trace(band, counts).color
                         : reflect(ray, hit, top_normal, top_layer, next.weight, counts);
    sum += band_hue(band.band.wavelength, width, samples) * seen;
  }
  return sum * (1.0f / static_cast<float>(samples));
}

}  // namespace durer
