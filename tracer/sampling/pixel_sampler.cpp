#include "tracer/sampling/pixel_sampler.h"

#include <bit>

namespace durer {

PixelSampler::PixelSampler(const ShadingScene& scene, const Camera& camera,
                           const Integrator& integrator)
    : scene_(scene),
      camera_(camera),
      integrator_(integrator),
      single_origin_(camera.has_single_origin()) {
  if (single_origin_) interiors_at(camera.node().location, interiors_at_camera_);
}

void PixelSampler::interiors_at(const Vec3& point, InteriorList& list) const {
  int found[InteriorList::kCapacity];
  const int count = scene_.world->containing_interiors(point, found, InteriorList::kCapacity);
  for (int i = 0; i < count; ++i) list.append(found[i]);
}

PixelColor PixelSampler::sample(double x, double y, RenderStatistics& statistics) const {
  ++statistics.samples;
  Ray ray;
  if (!camera_.generate_ray(x + 0.5, y + 0.5, ray)) return {RGB(0.0f), 1};
  TracedRay traced;
  traced.origin = ray.origin;
  traced.direction = ray.direction;
  traced.kind.primary = true;
  traced.path = extend_path(std::bit_cast<uint64_t>(x), std::bit_cast<uint64_t>(y));
  if (single_origin_) {
    traced.interiors = interiors_at_camera_;
  } else {
    interiors_at(ray.origin, traced.interiors);
  }
  ++statistics.rays.primary;
  const RayResult result = integrator_.trace(traced, statistics.rays);
  return {result.color, result.transmit};
}

}  // namespace durer
