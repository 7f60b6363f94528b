#include "tracer/lights/light.h"

#include <cmath>

#include "tracer/math/power.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

// 0 below low, 1 from high on, a cubic between.
double smooth_step(double low, double high, double x) {
  if (x < low) return 0;
  if (x >= high) return 1;
  const double u = (x - low) / (high - low);
  return (3 - 2 * u) * u * u;
}

}  // namespace

Light::Light(const LightNode& node)
    : node_(node),
      is_directed_(node.parallel || node.kind == LightKind::cylinder),
      is_attenuated_(node.kind != LightKind::point || node.fade_power > 0) {
  axis_ = normalize_or_zero(node.point_at - node.location);
  to_center_ = normalize_or_zero(node.location - node.point_at);
  if (node.size1 > 1) grid_step1_ = 1.0 / (node.size1 - 1);
  if (node.size2 > 1) grid_step2_ = 1.0 / (node.size2 - 1);
  if (node.kind == LightKind::spot) {
    cos_radius_ = std::cos(node.radius * (M_PI / 180));
    cos_falloff_ = std::cos(node.falloff * (M_PI / 180));
  }
}

LightDirection Light::along_axis(const Vec3& point, const Vec3& center) const {
  // The axis of a parallel area light starts at the (jittered) centre.
  const Vec3 direction = normalize_or_zero(center - node_.point_at);
  return {direction, dot(center - point, direction)};
}

double Light::attenuation_of_shape(const Vec3& point, const LightDirection& to_light) const {
  double result = 1;
  if (node_.kind == LightKind::spot) {
    // 1 for parallel rays, but not for each sample of area_illumination (measured on povray 3.7).
    double cosine = -dot(to_light.direction, axis_);
    // Behind a parallel light as well.
    if (to_light.distance <= 0) cosine = -cosine;
    if (cosine <= 0) return 0;
    result = node_.tightness == 0 ? 1.0 : power(cosine, node_.tightness);
    if (cos_radius_ > 0 && cosine < cos_radius_) {
      result *= smooth_step(cos_falloff_, cos_radius_, cosine);
    }
  } else if (node_.kind == LightKind::cylinder) {
    // One cylinder, also where every sample of an area light shines by itself.
    const Vec3 from_center = point - node_.location;
    const double along = dot(from_center, axis_);
    if (along <= 0) return 0;
    const double radial = std::sqrt(std::max(0.0, dot(from_center, from_center) - along * along));
    if (radial >= node_.falloff) return 0;
    const double edge = 1 - radial / node_.falloff;
    result = node_.tightness == 0 ? 1.0 : power(edge, node_.tightness);
    if (node_.radius > 0 && radial > node_.radius) {
      result *= smooth_step(0, 1 - node_.radius / node_.falloff, edge);
    }
  }
  if (node_.fade_power > 0 && std::abs(node_.fade_distance) > kEpsilon) {
    result *= 2 / (1 + power(to_light.distance / node_.fade_distance, node_.fade_power));
    // Behind a parallel light the distance is negative, and not every power of it exists.
    if (std::isnan(result)) return 0;
  }
  return result;
}

}  // namespace durer
