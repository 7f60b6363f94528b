#include "tracer/sampling/pixel_sampler.h"

#include <bit>

#include "tracer/intersect/bvh_beam.h"
#include "tracer/math/uncleared.h"
#include "tracer/world/pattern_services.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

uint64_t path_of(double x, double y) {
  return extend_path(std::bit_cast<uint64_t>(x), std::bit_cast<uint64_t>(y));
}

PixelColor color_of(const RayResult& seen) {
  return {seen.color, seen.transmit};
}

}  // namespace

PixelSampler::PixelSampler(const ShadingScene& scene, const Camera& camera,
                           const Integrator& integrator, int width, int height)
    : scene_(scene),
      camera_(camera),
      integrator_(integrator),
      looks_around_(camera.looks_around_each_origin()),
      max_depth_(camera.node().max_distance >= kEpsilon ? camera.node().max_distance : kFarAway) {
  if (camera.has_lens()) {
    const WorldPatternServices services(texture_settings(scene.scene, scene.options),
                                        scene.scene.settings);
    focal_blur_.emplace(camera.node(), services.settings());
  }
  if (!looks_around_) find_interiors_of_first_ray(width, height);
}

void PixelSampler::find_interiors_of_first_ray(int width, int height) {
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Ray ray;
      if (!camera_.generate_ray(x + 0.5, y + 0.5, 0, ray)) continue;
      interiors_at(ray.origin, interiors_of_first_ray_);
      return;
    }
  }
}

void PixelSampler::interiors_at(const Vec3& point, InteriorList& list) const {
  int found[InteriorList::kCapacity];
  const int count = scene_.world->containing_interiors(point, found, InteriorList::kCapacity);
  for (int i = 0; i < count; ++i) list.append(found[i]);
}

TracedRay PixelSampler::primary_ray() const {
  TracedRay primary;
  primary.max_depth = max_depth_;
  primary.kind.primary = true;
  primary.interiors = interiors_of_first_ray_;
  return primary;
}

[[gnu::always_inline]] inline RayResult PixelSampler::trace(TracedRay& primary, const Ray& ray,
                                                            uint64_t path,
                                                            RenderStatistics& statistics) const {
  primary.origin = ray.origin;
  primary.direction = ray.direction;
  primary.path = path;
  if (looks_around_) {
    primary.interiors = {};
    interiors_at(ray.origin, primary.interiors);
  }
  ++statistics.rays.primary;
  return integrator_.trace(primary, statistics.rays);
}

PixelColor PixelSampler::sample(double x, double y, RenderStatistics& statistics) const {
  ++statistics.samples;
  const PixelColor none{RGB(0.0f), 1};
  const uint64_t path = path_of(x, y);
  TracedRay primary = primary_ray();
  Ray ray;
  if (focal_blur_) {
    return focal_blur_->sample(x, y, [&](double sx, double sy, const Vec2& lens, int number) {
      if (!camera_.generate_lens_ray(sx + 0.5, sy + 0.5, lens, ray)) return none;
      return color_of(
          trace(primary, ray, extend_path(path, static_cast<uint64_t>(number)), statistics));
    });
  }
  if (camera_.rays_per_pixel() == 1) {
    if (!camera_.generate_ray(x + 0.5, y + 0.5, 0, ray)) return none;
    return color_of(trace(primary, ray, path, statistics));
  }
  // The mean of those rays that exist.
  PixelColor sum;
  int count = 0;
  for (int i = 0; i < camera_.rays_per_pixel(); ++i) {
    if (!camera_.generate_ray(x + 0.5, y + 0.5, i, ray)) continue;
    const RayResult seen =
        trace(primary, ray, extend_path(path, static_cast<uint64_t>(i)), statistics);
    sum.color += seen.color;
    sum.transmit += seen.transmit;
    ++count;
  }
  if (count == 0) return none;
  const float share = 1.0f / static_cast<float>(count);
  return {sum.color * share, sum.transmit * share};
}

void PixelSampler::sample_together(const Vec2* places, int count, PixelColor* colors,
                                   RenderStatistics& statistics) const {
  Ray ray[kMostTogether];
  int number[kMostTogether];
  int rays = 0;
  const bool one_each = !focal_blur_ && camera_.rays_per_pixel() == 1;
  for (int i = 0; i < count; ++i) {
    if (!one_each) {
      colors[i] = sample(places[i].x, places[i].y, statistics);
      continue;
    }
    ++statistics.samples;
    colors[i] = {RGB(0.0f), 1};
    if (camera_.generate_ray(places[i].x + 0.5, places[i].y + 0.5, 0, ray[rays])) {
      number[rays++] = i;
    }
  }
  TracedRay primary = primary_ray();
  BvhBeam beam;
  if (rays > 1 && scene_.world->make_beam(ray, rays, max_depth_, beam)) primary.beam = &beam;
  // Copied when all are there: a copy of what was just written by components waits for them.
  Uncleared<RayResult> seen[kMostTogether];
  for (int i = 0; i < rays; ++i) {
    const Vec2& place = places[number[i]];
    seen[i].emplace_result(
        [&] { return trace(primary, ray[i], path_of(place.x, place.y), statistics); });
  }
  for (int i = 0; i < rays; ++i) colors[number[i]] = color_of(seen[i].value);
}

}  // namespace durer
