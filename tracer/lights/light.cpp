#include "tracer/lights/light.h"

#include <cmath>

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
    double cosine = node_.parallel ? 1.0 : -dot(to_light.direction, axis_);
    if (to_light.distance <= 0 && !node_.parallel) cosine = -cosine;
    if (cosine <= 0) return 0;
    result = node_.tightness == 0 ? 1.0 : std::pow(cosine, node_.tightness);
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
    result = node_.tightness == 0 ? 1.0 : std::pow(edge, node_.tightness);
    if (node_.radius > 0 && radial > node_.radius) {
      result *= smooth_step(0, 1 - node_.radius / node_.falloff, edge);
    }
  }
  if (node_.fade_power > 0 && std::abs(node_.fade_distance) > kEpsilon) {
    result *= 2 / (1 + std::pow(to_light.distance / node_.fade_distance, node_.fade_power));
    // Behind a parallel light the distance is negative, and not every power of it exists.
    if (std::isnan(result)) return 0;
  }
  return result;
}

AreaLightGrid::AreaLightGrid(const Light& light, const Vec3& point)
    : node(light.node()),
      axis1(light.node().axis1),
      axis2(light.node().axis2),
      step1(light.grid_step1()),
      step2(light.grid_step2()) {
  if (!node.orient) return;
  // Turn the disc towards the point; its diameter is the first axis.
  const Vec3 towards = light.direction_from(point, node.location).direction;
  const Vec3 helper = std::abs(std::abs(towards.z) - 1) < 0.01 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const double diameter = length(axis1);
  const Vec3 first = normalize_or_zero(cross(towards, helper));
  axis1 = first * diameter;
  axis2 = normalize_or_zero(cross(towards, first)) * diameter;
}

Vec3 AreaLightGrid::sample(int i, int j, double jitter_i, double jitter_j) const {
  double u = i, v = j;
  if (node.jitter) {
    u += jitter_i - 0.5;
    v += jitter_j - 0.5;
  }
  u = step1 > 0 ? u * step1 - 0.5 : 0.0;
  v = step2 > 0 ? v * step2 - 0.5 : 0.0;
  if (node.circular) {
    u += 0.001;
    v += 0.001;
    const double scale = std::max(std::abs(u), std::abs(v)) / std::sqrt(u * u + v * v);
    u *= scale;
    v *= scale;
  }
  return node.location + u * axis1 + v * axis2;
}

}  // namespace durer
