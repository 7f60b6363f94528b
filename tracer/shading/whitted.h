// POV-Ray's light transport: Whitted's recursion with POV-Ray's shading model (spec/shading.md 7-11).
#pragma once

#include "tracer/shading/direct_light.h"
#include "tracer/shading/integrator.h"

namespace durer {

class WhittedIntegrator : public Integrator {
 public:
  // raycast: first hit, direct light and shadows, no recursion.
  enum class Depth { recursive, raycast };

  WhittedIntegrator(const ShadingScene& scene, Depth depth)
      : scene_(scene), direct_light_(scene), recursive_(depth == Depth::recursive) {}

  RayResult trace(const TracedRay& ray, RayCounts& counts) const override;

 private:
  // What all textures of one hit share.
  struct SurfaceHit {
    const SurfacePoint& surface;
    const WorldInterior& interior;
    TextureContext context;  // normal: facing the ray
    double depth;            // length of the segment that ends here
    bool inside_interior;    // the ray is in this object's interior
  };
  struct ReflectedLayer;

  void shade_surface(const TracedRay& ray, const SurfacePoint& surface, double depth,
                     RayCounts& counts, RayResult& result) const;
  void shade_texture(const TracedRay& ray, const SurfaceHit& hit, const CompiledTexture& texture,
                     const Vec3& point, RayCounts& counts, RGB& color, float& transmit) const;
  RGB shade_layer(const TracedRay& ray, const SurfaceHit& hit, const TextureLayer& layer,
                  const ColorRGBFT& pigment, const Vec3& normal, float opacity,
                  RayCounts& counts) const;
  RGB light_contribution(const TracedRay& ray, const SurfaceHit& hit, const TextureLayer& layer,
                         const ColorRGBFT& pigment, const Vec3& normal, float opacity, int light,
                         RayCounts& counts) const;
  RGB reflect(const TracedRay& ray, const SurfaceHit& hit, const Vec3& normal,
              const TextureLayer& layer, float weight, RayCounts& counts) const;
  // Light from behind the surface. True on total internal reflection.
  bool transmit_ray(const TracedRay& ray, const SurfaceHit& hit, const TextureLayer& top_layer,
                    const Vec3& top_normal, float weight, const RGB& filter, bool filtered,
                    RayCounts& counts, RGB& color, float& transmit) const;
  RGB refract_bands(const TracedRay& ray, const SurfaceHit& hit, const TextureLayer& top_layer,
                    const Vec3& top_normal, float weight, const InteriorList& inside, double ratio,
                    double dispersion, int samples, RayCounts& counts) const;

  const ShadingScene& scene_;
  DirectLight direct_light_;
  bool recursive_;
};

}  // namespace durer
