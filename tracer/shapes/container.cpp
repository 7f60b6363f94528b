#include "tracer/shapes/container.h"

#include <cmath>

namespace durer {

Container::Container(const ContainerNode& node)
    : is_sphere_(node.is_sphere),
      low_(glm::min(node.corner1, node.corner2)),
      high_(glm::max(node.corner1, node.corner2)),
      center_(node.center),
      radius_(node.radius) {}

Bounds Container::bounds() const {
  if (is_sphere_) return {center_ - Vec3(radius_), center_ + Vec3(radius_)};
  return {low_, high_};
}

bool Container::contains(const Vec3& p) const {
  if (is_sphere_) return dot(p - center_, p - center_) <= radius_ * radius_;
  return p.x >= low_.x && p.x <= high_.x && p.y >= low_.y && p.y <= high_.y && p.z >= low_.z &&
         p.z <= high_.z;
}

bool Container::cross(const ShapeRay& ray, BoxCrossing& crossing) const {
  if (!is_sphere_) return cross_box(low_, high_, ray, crossing);
  const double scale = 1 / length(ray.direction);
  const Vec3 d = ray.direction * scale, to_center = center_ - ray.origin;
  const double along = dot(to_center, d), distance2 = dot(to_center, to_center);
  const double radius2 = radius_ * radius_;
  if (distance2 >= radius2 && along < kGeometryEpsilon) return false;
  const double half2 = radius2 - distance2 + along * along;
  if (half2 <= kGeometryEpsilon) return false;
  const double half = std::sqrt(half2);
  crossing.near = (along - half) * scale;
  crossing.far = (along + half) * scale;
  return true;
}

bool Container::sphere_normal(const Vec3& p, Vec3& normal) const {
  if (!is_sphere_) return false;
  const double distance = length(p - center_);
  if (std::abs(distance - radius_) >= kGeometryEpsilon) return false;
  normal = (p - center_) / radius_;
  return true;
}

}  // namespace durer
