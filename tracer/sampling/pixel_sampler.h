// One sample of the picture: from pixel coordinates to a colour.
#pragma once

#include "tracer/cameras/camera.h"
#include "tracer/image/framebuffer.h"
#include "tracer/sampling/render.h"

namespace durer {

class PixelSampler {
 public:
  PixelSampler(const ShadingScene& scene, const Camera& camera, const Integrator& integrator);

  // x, y: pixel coordinates with integers at pixel centres. Not clipped to the picture.
  PixelColor sample(double x, double y, RenderStatistics& statistics) const;

 private:
  void interiors_at(const Vec3& point, InteriorList& list) const;

  const ShadingScene& scene_;
  const Camera& camera_;
  const Integrator& integrator_;
  bool single_origin_;
  InteriorList interiors_at_camera_;
};

}  // namespace durer
