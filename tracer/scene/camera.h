// camera{} after its keywords' rules (spec/shading.md 3): the vectors are final.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tracer/scene/object.h"

namespace durer {

enum class CameraKind : uint8_t {
  perspective, orthographic, fisheye, ultra_wide_angle, omnimax, panoramic, spherical, cylinder1,
  cylinder2, cylinder3, cylinder4, mesh
};

struct CameraNode {
  CameraKind kind = CameraKind::perspective;
  Vec3 location{0}, direction{0, 0, 1}, up{0, 1, 0}, right{1.33, 0, 0}, sky{0, 1, 0};
  Vec3 look_at{0, 0, 1};
  double angle = 0;  // degrees; 0: not given
  Vec2 spherical_angles{360, 180};
  // Focal blur
  double aperture = 0;
  int blur_samples = 0;      // the lens positions used at most
  int min_blur_samples = 0;  // `blur_samples min, max`
  double confidence = 0.9, variance = 0.0001;
  Vec3 focal_point{0};
  double focal_distance = 1;
  std::shared_ptr<const PigmentNode> bokeh;
  std::shared_ptr<const NormalNode> normal;
  // mesh_camera { rays_per_pixel, distribution_type, [max_distance] mesh... }
  int rays_per_pixel = 1;
  int distribution = 0;
  double max_distance = 0;
  bool mesh_smooth = false;
  std::vector<ObjectPtr> mesh_objects;
  SourcePosition position;
};

}  // namespace durer
