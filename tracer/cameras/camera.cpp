#include "tracer/cameras/camera.h"

#include <cmath>

#include "tracer/math/transform.h"
#include "tracer/scene/not_supported.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

double radians(double degrees) { return degrees * (M_PI / 180); }

// The angle of (x, y) on a circle of radius r, in [-pi/2, 3pi/2].
double polar_angle(double x, double y, double r) {
  if (r == 0) return 0;
  const double angle = std::asin(y / r);
  return x >= 0 ? angle : M_PI - angle;
}

}  // namespace

Camera::Camera(const CameraNode& node, int width, int height)
    : node_(node),
      width_(width),
      height_(height),
      direction_(normalize_or_zero(node.direction)),
      right_(normalize_or_zero(node.right)),
      up_(normalize_or_zero(node.up)),
      right_length_(length(node.right)),
      up_length_(length(node.up)) {
  if (node.kind == CameraKind::mesh) throw NotSupported("mesh_camera", node.position);
  if (node.normal) throw NotSupported("a normal in the camera", node.position);
  if (node.aperture != 0 && node.blur_samples > 0) {
    throw NotSupported("focal blur", node.position);
  }
}

bool Camera::has_single_origin() const {
  return node_.kind != CameraKind::orthographic && node_.kind != CameraKind::cylinder3 &&
         node_.kind != CameraKind::cylinder4;
}

bool Camera::generate_ray(double x, double y, Ray& ray) const {
  const double u = x / width_, v = y / height_;
  const double a = u - 0.5, b = 0.5 - v;
  const Vec3 &r = right_, &up = up_, &d = direction_;
  ray.origin = node_.location;
  switch (node_.kind) {
    case CameraKind::perspective:
      ray.direction = node_.direction + a * node_.right + b * node_.up;
      break;
    case CameraKind::orthographic:
      ray.origin = node_.location + a * node_.right + b * node_.up;
      ray.direction = node_.direction;
      break;
    case CameraKind::fisheye: {
      const double px = 2 * a * right_length_, py = 2 * b * up_length_;
      const double radius = std::sqrt(px * px + py * py);
      if (radius > 1) return false;
      const double phi = polar_angle(px, py, radius), t = radius * radians(node_.angle) / 2;
      ray.direction =
          std::cos(phi) * std::sin(t) * r + std::sin(phi) * std::sin(t) * up + std::cos(t) * d;
      break;
    }
    case CameraKind::ultra_wide_angle: {
      const double alpha = a * radians(node_.angle);
      const double beta = b * radians(node_.angle) * up_length_ / right_length_;
      ray.direction = std::sin(alpha) * r + std::sin(beta) * up +
                      std::cos(alpha) * std::cos(beta) * d;
      break;
    }
    case CameraKind::omnimax: {
      const double q = right_length_ / up_length_;
      double px = 2 * a, py = 2 * b;
      if (q > 1.283458) {
        px *= q / 1.283458;
        py = (py - 1) / 1.283458 + 1;
      } else if (q > 1) {
        py = (py - 1) / q + 1;
      } else {
        py /= q;
      }
      const double radius = std::sqrt(px * px + py * py);
      if (radius > 1) return false;
      const double phi = polar_angle(px, py, radius);
      const double t = 1.411269 * radius - 0.09439 * radius * radius * radius +
                       0.25674 * std::pow(radius, 5);
      if (std::sin(phi) * std::sin(t) < std::tan(radians(135)) * std::cos(t)) return false;
      ray.direction =
          std::cos(phi) * std::sin(t) * r + std::sin(phi) * std::sin(t) * up + std::cos(t) * d;
      break;
    }
    case CameraKind::panoramic: {
      const double c = (1 - u) * M_PI, s = M_PI * b;
      double tangent;
      if (std::abs(M_PI / 2 - std::abs(s)) < kEpsilon) {
        tangent = s > 0 ? 2e10 : -2e10;
      } else {
        tangent = std::tan(s);
      }
      ray.direction = std::cos(c) * node_.right + tangent * node_.up + std::sin(c) * node_.direction;
      break;
    }
    case CameraKind::cylinder1: {
      const double alpha = a * radians(node_.angle);
      ray.direction = std::sin(alpha) * r + b * up_length_ * up + std::cos(alpha) * d;
      break;
    }
    case CameraKind::cylinder2: {
      const double beta = b * radians(node_.angle);
      ray.direction = a * right_length_ * r + std::sin(beta) * up + std::cos(beta) * d;
      break;
    }
    case CameraKind::cylinder3: {
      const double alpha = a * radians(node_.angle);
      ray.origin = node_.location + b * up_length_ * up;
      ray.direction = std::sin(alpha) * r + std::cos(alpha) * d;
      break;
    }
    case CameraKind::cylinder4: {
      const double beta = b * radians(node_.angle);
      ray.origin = node_.location + a * right_length_ * r;
      ray.direction = std::sin(beta) * up + std::cos(beta) * d;
      break;
    }
    case CameraKind::spherical: {
      const double longitude = a * radians(node_.spherical_angles.x);
      const double latitude = b * radians(node_.spherical_angles.y);
      const Transform tilt = Transform::axis_rotation(r, -latitude);
      const Transform turn = Transform::axis_rotation(up, longitude);
      ray.direction = turn.direction(tilt.direction(node_.direction));
      break;
    }
    case CameraKind::mesh:
      return false;
  }
  ray.direction = normalize_or_zero(ray.direction);
  return true;
}

}  // namespace durer
