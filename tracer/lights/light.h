// A light source made ready for shading (spec/shading.md 9).
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/scene/light.h"

namespace durer {

// Where a light stands as seen from a point.
struct LightDirection {
  Vec3 direction;   // unit, from the point to the light
  double distance;  // to the light; may be negative behind a parallel light's plane
};

class Light {
 public:
  explicit Light(const LightNode& node);

  const LightNode& node() const { return node_; }
  // From a light centre (the node's, or an area light's sample).
  LightDirection direction_from(const Vec3& point, const Vec3& center) const {
    return is_directed_ ? along_axis(point, center) : towards(center - point);
  }
  // The same from the node's own centre.
  LightDirection direction_from(const Vec3& point) const {
    if (!is_directed_) return towards(node_.location - point);
    return {to_center_, dot(node_.location - point, to_center_)};
  }
  // Cone, cylinder and distance attenuation of 9.2 for a direction as above.
  double attenuation(const Vec3& point, const LightDirection& to_light) const {
    return is_attenuated_ ? attenuation_of_shape(point, to_light) : 1;
  }
  // Rays run along the axis: parallel light and cylinders.
  bool is_directed() const { return is_directed_; }
  // The direction in which the light shines (spot, cylinder, parallel).
  const Vec3& axis() const { return axis_; }
  // From one sample of an area light's grid to the next, as a share of its axis.
  double grid_step1() const { return grid_step1_; }
  double grid_step2() const { return grid_step2_; }

 private:
  static LightDirection towards(const Vec3& to_center) {
    const double distance = length(to_center);
    return {distance > 0 ? to_center * (1 / distance) : to_center, distance};
  }
  LightDirection along_axis(const Vec3& point, const Vec3& center) const;
  double attenuation_of_shape(const Vec3& point, const LightDirection& to_light) const;

  LightNode node_;
  bool is_directed_;
  bool is_attenuated_;  // by its shape or by distance
  Vec3 axis_{0, 0, 1};
  Vec3 to_center_{0, 0, 0};  // of directed lights: against the axis
  double cos_radius_ = 1, cos_falloff_ = 1;
  double grid_step1_ = 0, grid_step2_ = 0;
};

}  // namespace durer
