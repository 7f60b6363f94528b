// POV-Ray's light transport: Whitted's recursion with POV-Ray's shading model (spec/shading.md
// 7-11).
#pragma once

#include <algorithm>
#include <cmath>

#include "tracer/math/uncleared.h"
#include "tracer/shading/direct_light.h"
#include "tracer/shading/indirect_light.h"
#include "tracer/shading/integrator.h"
#include "tracer/shading/ray_observer.h"

namespace durer {

class WhittedIntegrator : public Integrator {
 public:
  // raycast: first hit, direct light and shadows, no recursion.
  enum class Depth { recursive, raycast };

  // `indirect`, `observer`: null for none; they must live as long as this.
  WhittedIntegrator(const ShadingScene& scene, Depth depth, const IndirectLight* indirect = nullptr,
                    RayObserver* observer = nullptr)
      : scene_(scene),
        direct_light_(scene),
        least_seen_light_(std::ldexp(kLeastSeen, -scene.options.bits) /
                          static_cast<float>(std::max<size_t>(1, scene.lights.size()))),
        recursive_(depth == Depth::recursive),
        indirect_(indirect),
        observer_(observer) {}

  RayResult trace(const TracedRay& ray, RayCounts& counts) const override;

 private:
  // The light that reaches a hit, once known; for surfaces with several layers or textures.
  class ShadowedLights {
   public:
    static constexpr int kMost = 8;
    // Before shadows: to be filled in by who asks first.
    bool knows_unshadowed(int place) const { return unshadowed_known_ >> place & 1; }
    ArrivingLight& unshadowed(int place) {
      unshadowed_known_ |= 1u << place;
      return unshadowed_[place].value;
    }
    // After shadows.
    bool knows(int place) const { return color_known_ >> place & 1; }
    const RGB& color(int place) const { return color_[place].value; }
    void remember(int place, const RGB& color) {
      color_known_ |= 1u << place;
      color_[place].emplace(color);
    }

   private:
    Uncleared<ArrivingLight> unshadowed_[kMost];
    Uncleared<RGB> color_[kMost];
    uint32_t unshadowed_known_ = 0, color_known_ = 0;
  };
  // What all textures of one hit share.
  struct SurfaceHit {
    SurfaceHit(const TracedRay& ray, const SurfacePoint& point, const WorldInterior& inside,
               double length, const Vec3& facing_normal)
        : surface(point),
          interior(inside),
          context{facing_normal, ray.direction, point.point, point.uv, true},
          depth(length),
          inside_interior(ray.interiors.find(point.object->interior) >= 0),
          last_normal(facing_normal) {}

    const SurfacePoint& surface;
    const WorldInterior& interior;
    TextureContext context;            // normal: facing the ray
    double depth;                      // length of the segment that ends here
    bool inside_interior;              // the ray is in this object's interior
    ShadowedLights* lights = nullptr;  // null: asked for once only
    // Of the layer shaded last: `slope` sees it where the next texture of a map is chosen.
    mutable Vec3 last_normal;
    mutable bool is_bumped = false;  // last_normal is some layer's
    // Indirect light is asked once for all layers.
    mutable bool ambient_asked = false, has_ambient = false;
    mutable RGB ambient{0.0f};
  };
  struct ReflectedLayer;
  class PhotonLobes;

  RayResult follow(const TracedRay& ray, RayCounts& counts) const;
  void shade_surface(const TracedRay& ray, const SurfacePoint& surface, double depth,
                     RayCounts& counts, RayResult& result) const;
  void shade_texture(const TracedRay& ray, const SurfaceHit& hit, const CompiledTexture& texture,
                     const Vec3& point, EnclosingFrames& frames, RayCounts& counts, RGB& color,
                     float& transmit) const;
  RGB shade_layer(const TracedRay& ray, const SurfaceHit& hit, const TextureLayer& layer,
                  const ColorRGBFT& pigment, const Vec3& normal, float opacity, const RGB& filter,
                  RayCounts& counts) const;
  // Indirect light, where there is any, in place of a layer's ambient.
  [[gnu::noinline]] void replace_ambient(const TracedRay& ray, const SurfaceHit& hit,
                                         const TextureLayer& layer, const RGB& pigment,
                                         const Vec3& normal, float opacity, const RGB& filter,
                                         RGB& ambient) const;
  RGB photon_light(const TracedRay& ray, const SurfaceHit& hit, const TextureLayer& layer,
                   const RGB& pigment, const Vec3& normal, float opacity) const;
  // To the observer, which must be there. Cold, so that renderers without one pay for a test only.
  [[gnu::cold, gnu::noinline]] void report(const TracedRay& ray, ContributionKind kind,
                                           const RGB& color, int light = -1) const;
  RGB light_contribution(const TracedRay& ray, const SurfaceHit& hit, const TextureLayer& layer,
                         const ColorRGBFT& pigment, const Vec3& normal, float opacity, int light,
                         int place, RayCounts& counts) const;
  RGB reflect(const TracedRay& ray, const SurfaceHit& hit, const Vec3& normal,
              const TextureLayer& layer, float weight, RayCounts& counts) const;
  // Light from behind the surface. True on total internal reflection.
  bool transmit_ray(const TracedRay& ray, const SurfaceHit& hit, const TextureLayer& top_layer,
                    const Vec3& top_normal, float weight, const RGB& filter, bool filtered,
                    RayCounts& counts, RGB& color, float& transmit) const;
  // `next`: the ray that goes on, but for its direction and wavelength.
  RGB refract_bands(const TracedRay& ray, const TracedRay& next, const SurfaceHit& hit,
                    const TextureLayer& top_layer, const Vec3& top_normal, double ratio,
                    double dispersion, int samples, RayCounts& counts) const;

  // What all lights together may leave out of a hit, in codes of the picture: less than 1/5,000 after the
  // sRGB curve, also in the dark, where it is steepest. 1/256 showed: codes amid two fell to the other
  // side, and pixels just over the threshold of antialiasing were left alone.
  static constexpr float kLeastSeen = 1.0f / (1 << 16);

  const ShadingScene& scene_;
  DirectLight direct_light_;
  float least_seen_light_;  // the share of one
  bool recursive_;
  const IndirectLight* indirect_;
  RayObserver* observer_;
};

}  // namespace durer
