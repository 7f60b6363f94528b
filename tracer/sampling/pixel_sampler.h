// One sample of the picture: from pixel coordinates to a colour.
#pragma once

#include <optional>

#include "tracer/cameras/camera.h"
#include "tracer/image/framebuffer.h"
#include "tracer/sampling/focal_blur.h"
#include "tracer/sampling/render.h"

namespace durer {

class PixelSampler {
 public:
  PixelSampler(const ShadingScene& scene, const Camera& camera, const Integrator& integrator,
               int width, int height);

  // x, y: pixel coordinates with integers at pixel centres. Not clipped to the picture. With focal
  // blur and mesh cameras the mean of many rays.
  PixelColor sample(double x, double y, RenderStatistics& statistics) const;
  // The same of places that lie close together, at most kMostTogether: quicker, not different.
  static constexpr int kMostTogether = 32;
  void sample_together(const Vec2* places, int count, PixelColor* colors,
                       RenderStatistics& statistics) const;

 private:
  // What all rays from the camera share.
  TracedRay primary_ray() const;
  // Traces `primary`, which gets this ray and path.
  RayResult trace(TracedRay& primary, const Ray& ray, uint64_t path,
                  RenderStatistics& statistics) const;
  void interiors_at(const Vec3& point, InteriorList& list) const;
  void find_interiors_of_first_ray(int width, int height);

  const ShadingScene& scene_;
  const Camera& camera_;
  const Integrator& integrator_;
  std::optional<FocalBlur> focal_blur_;
  bool looks_around_;
  InteriorList interiors_of_first_ray_;
  double max_depth_;
};

}  // namespace durer
