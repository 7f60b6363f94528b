// How much of a light reaches a point: shadow rays, area lights, transparent shadows
// (spec/shading.md 9.3, 10).
#pragma once

#include "tracer/shading/integrator.h"
#include "tracer/shading/shading_scene.h"

namespace durer {

// The light of one source at a point, after cone and distance, before shadows.
struct ArrivingLight {
  RGB color{0.0f};
  LightDirection direction;
};

class DirectLight {
 public:
  explicit DirectLight(const ShadingScene& scene) : scene_(scene) {}

  // Direction and colour of 9.1 and 9.2. Into a place that stays: a copy of what was just written by
  // components waits for them.
  void find_unshadowed(int index, const Vec3& point, ArrivingLight& result) const {
    const Light& light = scene_.lights[index];
    const LightNode& node = light.node();
    result.direction = light.direction_from(point);
    // With area_illumination each sample is attenuated by itself, later.
    const bool per_sample =
        node.area_illumination && node.area && scene_.options.quality >= 5;
    const double attenuation =
        per_sample ? 1 : light.attenuation(point, result.direction);
    result.color = node.color.times(attenuation);
  }
  // Takes from `color` what lies between the start and the light; black: nothing arrives. `ray` is the
  // ray that saw the point.
  void apply_shadow(int light, const ShadowStart& start, const TracedRay& ray,
                    const LightDirection& to_light, RGB& color, RayCounts& counts) const;

 private:
  // Follows one shadow ray from the point to `center`; multiplies color.
  void trace_shadow(int light, const ShadowStart& start, const LightDirection& to_light,
                    const TracedRay& ray, RGB& color, RayCounts& counts) const;
  // The same past the opaque objects: through those that let light through, and fog.
  void filter_shadow(int light, const Vec3& point, const LightDirection& to_light, double margin,
                     const TracedRay& ray, RGB& color) const;
  // The surface of a remembered solid, before its turn comes.
  void filter_remembered(const Vec3& point, const LightDirection& to_light, double margin,
                         const TracedRay& ray, RGB& color) const;
  RGB area_shadow(int light, const ShadowStart& start, const TracedRay& ray, const RGB& color,
                  RayCounts& counts) const;
  bool passes_projection(int light, const Vec3& point, const LightDirection& to_light,
                         double& margin) const;

  const ShadingScene& scene_;
};

// The share of light that a surface lets through, per channel (10.3). `interiors`: of the ray.
RGB surface_transmittance(const ShadingScene& scene, const SurfacePoint& surface,
                          const Vec3& direction, const InteriorList& interiors,
                          double segment_length);

// Whether that share is none.
bool stops_light(const ShadingScene& scene, const SurfacePoint& surface, const Vec3& direction);

// The fade of an interior over a segment (11.5).
RGB interior_fade(const InteriorNode& interior, double length);

}  // namespace durer
