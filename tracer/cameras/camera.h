// From a place on the picture to a ray (spec/shading.md 3.1).
#pragma once

#include "tracer/math/ray.h"
#include "tracer/scene/camera.h"

namespace durer {

class Camera {
 public:
  // Throws NotSupported for kinds that are not rendered yet.
  Camera(const CameraNode& node, int width, int height);

  // x, y in pixels, (0.5, 0.5) the centre of the top left one. False: no ray here (outside a round
  // image).
  bool generate_ray(double x, double y, Ray& ray) const;
  // True if all rays start at one point.
  bool has_single_origin() const;
  const CameraNode& node() const { return node_; }

 private:
  CameraNode node_;
  double width_, height_;
  Vec3 direction_, right_, up_;  // unit vectors of direction, right, up
  double right_length_, up_length_;
};

}  // namespace durer
