// plane { <normal>, distance }                                       (spec/geometry.md 14.1)
#include "tracer/shapes/plane.h"

#include <cmath>

namespace durer {

bool Plane::closest(const ShapeRay& ray, HitStack&, ShapeHit& hit) const {
  const double slope = dot(normal_, ray.direction);
  if (std::abs(slope) < kGeometryEpsilon) return false;
  const double t = (distance_ - dot(normal_, ray.origin)) / slope;
  if (!(t >= kLeastHitDepth && t <= kGreatestDepth && t < ray.t_max)) return false;
  hit.t = t;
  hit.part = 0;
  return true;
}

void Plane::hits(const ShapeRay& ray, HitStack& out) const {
  LineHits met;
  line_hits(ray, met);
  met.push_to(out);
}

void Plane::line_hits(const ShapeRay& ray, LineHits& out) const {
  const double slope = dot(normal_, ray.direction);
  if (std::abs(slope) < kGeometryEpsilon) return;
  const double t = (distance_ - dot(normal_, ray.origin)) / slope;
  if (t >= 1e-6 && t <= kGreatestDepth) out.add(t);
}

bool Plane::inside(const Vec3& p) const {
  return dot(normal_, p) - distance_ < kGeometryEpsilon;
}

std::shared_ptr<const Shape> Plane::transformed(const Transform& transform) const {
  switch (transform.kind) {
    case TransformKind::translation:
      return std::make_shared<Plane>(normal_, distance_ + dot(normal_, transform.forward.row[3]));
    case TransformKind::rotation:
      return std::make_shared<Plane>(transform.normal(normal_), distance_);
    case TransformKind::scaling: {
      const Vec3 scaled = normal_ / Vec3(transform.forward.row[0].x, transform.forward.row[1].y,
                                         transform.forward.row[2].z);
      const double size = length(scaled);  // used as povray does, to the last digit
      return std::make_shared<Plane>(scaled * (1 / size), distance_ / size);
    }
    default:
      return nullptr;
  }
}

std::shared_ptr<const Shape> Plane::inverted() const {
  return std::make_shared<Plane>(-normal_, -distance_);
}

PlacedShape compile(const PlaneNode& node, const ShapeContext&) {
  return {std::make_shared<Plane>(node.normal, node.distance), false, {}};
}

}  // namespace durer
