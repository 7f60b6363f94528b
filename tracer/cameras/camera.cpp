#include "tracer/cameras/camera.h"

#include <cmath>

#include "tracer/math/transform.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

double radians(double degrees) {
  return degrees * (M_PI / 180);
}

// Divided by the length, as POV-Ray does here and nowhere else: last digits show where a plane lies in
// the jump of its pattern (scenes/gallery/cameras/last_digits_*.pov; `spherical` divides nothing).
Vec3 divided_by_length(const Vec3& v) {
  const double squared = dot(v, v);
  return squared > 0 ? v / std::sqrt(squared) : v;
}

// The angle of (x, y) on a circle of radius r, in [-pi/2, 3pi/2].
double polar_angle(double x, double y, double r) {
  if (r == 0) return 0;
  const double angle = std::asin(y / r);
  return x >= 0 ? angle : M_PI - angle;
}

}  // namespace

Camera::Camera(const CameraNode& node, int width, int height, const TextureSettings& textures)
    : node_(node),
      width_(width),
      height_(height),
      is_plain_(node.kind == CameraKind::perspective && !node.normal),
      direction_(divided_by_length(node.direction)),
      right_(divided_by_length(node.right)),
      up_(divided_by_length(node.up)),
      right_length_(length(node.right)),
      up_length_(length(node.up)),
      angle_(radians(node.angle)) {
  if (node.kind == CameraKind::mesh) mesh_ = std::make_unique<MeshCamera>(node, width, height);
  if (node.normal) normal_ = compile_normal(*node.normal, textures);
  const Vec3 across = unit_or_zero(cross(node.up, node.direction));
  lens_right_ = node.aperture / 2 * across;
  lens_up_ = node.aperture / 2 * unit_or_zero(cross(node.direction, across));
  focus_ = node.focal_distance / length(node.direction);
}

bool Camera::looks_around_each_origin() const {
  switch (node_.kind) {
    case CameraKind::orthographic:
    case CameraKind::cylinder3:
    case CameraKind::cylinder4:
      return true;
    case CameraKind::perspective:
      return has_lens();
    default:
      return false;
  }
}

int Camera::rays_per_pixel() const {
  return mesh_ ? node_.rays_per_pixel : 1;
}

bool Camera::generate_ray(double x, double y, int ray_of_pixel, Ray& ray) const {
  if (is_plain_) [[likely]] {
    ray = {node_.location,
           unit_or_zero(perspective(share_of_width(x) - 0.5, share_of_height(y) - 0.5))};
    return true;
  }
  View view;
  if (!view_of(x, y, ray_of_pixel, view)) return false;
  ray = {view.origin, finished_direction(view.direction, view.place)};
  return true;
}

bool Camera::generate_lens_ray(double x, double y, const Vec2& lens, Ray& ray) const {
  View view;
  if (!view_of(x, y, 0, view)) return false;
  // The ray through the centre of the lens meets this one in the focal plane. Cameras whose rays
  // start side by side lose that.
  const Vec3 offset = lens.x * lens_right_ - lens.y * lens_up_;
  ray = {node_.location + offset, finished_direction(focus_ * view.direction - offset, view.place)};
  return true;
}

Vec3 Camera::finished_direction(const Vec3& direction, const Vec2& place) const {
  const Vec3 straight = unit_or_zero(direction);
  if (!normal_) return straight;
  TextureContext context;
  context.normal = straight;
  context.ray_direction = straight;
  return unit_or_zero(normal_->perturb({place.x, place.y, 0}, context, straight));
}

bool Camera::view_of_fisheye(double a, double b, View& view) const {
  const double x = 2 * a * right_length_, y = 2 * b * up_length_;
  const double radius = std::sqrt(x * x + y * y);
  if (radius > 1) return false;
  const double phi = polar_angle(x, y, radius), t = radians(radius * (node_.angle / 2));
  view.direction = std::cos(phi) * std::sin(t) * right_ + std::sin(phi) * std::sin(t) * up_ +
                   std::cos(t) * direction_;
  view.place = {phi, t};
  return true;
}

bool Camera::view_of_omnimax(double a, double b, View& view) const {
  const double q = right_length_ / up_length_;
  double x = 2 * a, y = 2 * b;
  if (q > 1.283458) {
    x *= q / 1.283458;
    y = (y - 1) / 1.283458 + 1;
  } else if (q > 1) {
    y = (y - 1) / q + 1;
  } else {
    y /= q;
  }
  const double radius = std::sqrt(x * x + y * y);
  if (radius > 1) return false;
  const double phi = polar_angle(x, y, radius);
  const double t = 1.411269 * radius - 0.09439 * radius * radius * radius +
                   0.25674 * radius * radius * radius * radius * radius;
  if (std::sin(phi) * std::sin(t) < std::tan(radians(135)) * std::cos(t)) return false;
  view.direction = std::cos(phi) * std::sin(t) * right_ + std::sin(phi) * std::sin(t) * up_ +
                   std::cos(t) * direction_;
  view.place = {phi, t};
  return true;
}

bool Camera::view_of(double x, double y, int ray_of_pixel, View& view) const {
  const double u = share_of_width(x), v = share_of_height(y);
  const double a = u - 0.5, b = v - 0.5;
  view.origin = node_.location;
  switch (node_.kind) {
    case CameraKind::perspective:
      view.direction = perspective(a, b);
      view.place = {a, b};
      break;
    case CameraKind::orthographic:
      view.origin = node_.location + a * node_.right + b * node_.up;
      view.direction = node_.direction;
      view.place = {a, b};
      break;
    case CameraKind::fisheye:
      return view_of_fisheye(a, b, view);
    case CameraKind::ultra_wide_angle: {
      const double alpha = a * angle_;
      const double beta = b * radians(node_.angle * (up_length_ / right_length_));
      view.direction = std::sin(alpha) * right_ + std::sin(beta) * up_ +
                       std::cos(alpha) * std::cos(beta) * direction_;
      view.place = {alpha, beta};
      break;
    }
    case CameraKind::omnimax:
      return view_of_omnimax(a, b, view);
    case CameraKind::panoramic: {
      const double c = (1 - u) * M_PI, s = M_PI * b;
      const bool is_vertical = std::abs(M_PI / 2 - std::abs(s)) < kEpsilon;
      const double tangent = is_vertical ? std::copysign(2e10, s) : std::tan(s);
      view.direction =
          std::cos(c) * node_.right + tangent * node_.up + std::sin(c) * node_.direction;
      view.place = {c, s};
      break;
    }
    case CameraKind::cylinder1: {
      const double alpha = a * angle_;
      view.direction =
          std::sin(alpha) * right_ + b * up_length_ * up_ + std::cos(alpha) * direction_;
      view.place = {alpha, b * up_length_};
      break;
    }
    case CameraKind::cylinder2: {
      const double beta = b * angle_;
      view.direction =
          a * right_length_ * right_ + std::sin(beta) * up_ + std::cos(beta) * direction_;
      view.place = {a * right_length_, beta};
      break;
    }
    case CameraKind::cylinder3: {
      const double alpha = a * angle_;
      view.origin = node_.location + b * up_length_ * up_;
      view.direction = std::sin(alpha) * right_ + std::cos(alpha) * direction_;
      view.place = {alpha, b * up_length_};
      break;
    }
    case CameraKind::cylinder4: {
      const double beta = b * angle_;
      view.origin = node_.location + a * right_length_ * right_;
      view.direction = std::sin(beta) * up_ + std::cos(beta) * direction_;
      view.place = {a * right_length_, beta};
      break;
    }
    case CameraKind::spherical: {
      const double longitude = a * radians(node_.spherical_angles.x);
      const double latitude = b * radians(node_.spherical_angles.y);
      const Transform tilt = Transform::axis_rotation(unit_or_zero(node_.right), -latitude);
      const Transform turn = Transform::axis_rotation(unit_or_zero(node_.up), longitude);
      view.direction = turn.direction(tilt.direction(node_.direction));
      view.place = {longitude, latitude};
      break;
    }
    case CameraKind::mesh: {
      Ray ray;
      if (!mesh_->generate_ray(x, y, ray_of_pixel, ray)) return false;
      view.origin = ray.origin;
      view.direction = ray.direction;
      break;
    }
  }
  return true;
}

}  // namespace durer
