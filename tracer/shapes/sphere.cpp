// sphere { <center>, radius }                                        (spec/geometry.md 12.1)
//
// A sphere stays one under translate, rotate and uniform scale; any other transform is kept beside
// it and makes it an ellipsoid.
#include "tracer/shapes/sphere.h"

#include <cmath>

#include "tracer/shapes/shape.h"
#include "tracer/shapes/spherical_angle.h"

namespace durer {
namespace {

class Sphere : public Shape {
 public:
  Sphere(const Vec3& center, double radius) : center_(center), radius_(radius) {}

  Bounds bounds() const override { return {center_ - Vec3(radius_), center_ + Vec3(radius_)}; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    LineHits met;
    line_hits(ray, met);
    met.push_to(out);
  }

  void line_hits(const ShapeRay& ray, LineHits& out) const override {
    double near, far;
    const double stretch = depths(ray, near, far);
    if (stretch == 0) return;
    if (near > 1e-6 && near < kGreatestDepth) out.add(near / stretch);
    if (far > 1e-6 && far < kGreatestDepth) out.add(far / stretch);
  }

  bool closest(const ShapeRay& ray, HitStack&, ShapeHit& hit) const override {
    double near, far;
    const double stretch = depths(ray, near, far);
    if (stretch == 0) return false;
    // Which of the two counts processors cannot guess: no branch.
    const bool enters = (near > 1e-6) & (near >= kLeastHitDepth * stretch);
    const double depth = enters ? near : far;
    const double t = ray.unit_direction ? depth : depth / stretch;
    hit.t = t;
    hit.part = 0;
    return (depth > 1e-6) & (depth < kGreatestDepth) & (t >= kLeastHitDepth) & (t < ray.t_max);
  }

  bool inside(const Vec3& p) const override {
    const Vec3 d = p - center_;
    return dot(d, d) < radius_ * radius_;
  }
  bool inside_inverted(const Vec3& p) const override {
    const Vec3 d = p - center_;
    return dot(d, d) > radius_ * radius_;
  }
  Vec3 normal(const Vec3& p, const ShapeHit&) const override {
    return (p - center_) * (1 / radius_);
  }
  bool has_unit_normals() const override { return true; }

  Vec2 uv(const Vec3& p, const Vec3&, const ShapeHit&) const override {
    Vec3 d = p - center_;
    if (orientation_) d = orientation_->direction(d);
    d /= length(d);
    const double sine = d.y > 1 ? 1 : (d.y < -1 ? -1 : d.y);
    return {spherical_angle(d.x, d.z) / (2 * M_PI), 0.5 + std::asin(sine) / M_PI};
  }

  std::shared_ptr<const Shape> transformed(const Transform& transform) const override {
    const TransformKind kind = transform.kind;
    double factor = 1;
    if (kind == TransformKind::scaling) {
      const Vec3 s{transform.forward.row[0].x, transform.forward.row[1].y,
                   transform.forward.row[2].z};
      if (s.x != s.y || s.x != s.z) return nullptr;
      factor = s.x;
    } else if (kind == TransformKind::general) {
      return nullptr;
    }
    auto result = std::make_shared<Sphere>(transform.point(center_), radius_ * std::abs(factor));
    result->orientation_ = orientation_;
    if (kind == TransformKind::rotation || factor < 0) {
      // Longitude and latitude are taken back through all turns.
      Matrix back = transform.inverse;
      back.row[3] = Vec3(0);
      result->orientation_ =
          std::make_shared<const Matrix>(orientation_ ? back * *orientation_ : back);
    }
    return result;
  }
  std::shared_ptr<const Shape> beside_transform() const override;
  bool is_exempt_from_box_test() const override { return true; }
  bool is_convex_solid() const override { return true; }
  bool is_quickly_missed() const override { return true; }

 protected:
  // Both depths in normalised local space; returns how many times those in the world they are, 0 for
  // a miss.
  double depths(const ShapeRay& ray, double& near, double& far) const {
    Vec3 direction = ray.direction;
    double stretch = 1;
    if (!ray.unit_direction) {
      stretch = length(direction);
      direction *= 1 / stretch;
    }
    const Vec3 to_center = center_ - ray.origin;
    const double squared = dot(to_center, to_center);
    const double along = dot(to_center, direction);
    const double radius2 = radius_ * radius_;
    const double half_chord2 = radius2 - squared + along * along;
    const bool is_behind = (squared >= radius2) & (along < kGeometryEpsilon);
    if (is_behind | !(half_chord2 > kGeometryEpsilon)) return 0;
    const double half_chord = std::sqrt(half_chord2);
    near = along - half_chord;
    far = along + half_chord;
    return stretch;
  }

  Vec3 center_;
  double radius_;
  std::shared_ptr<const Matrix> orientation_;
};

// A sphere under a transform. povray finds its hits along the moved ray made length 1, and moves
// them back.
class Ellipsoid final : public Sphere {
 public:
  explicit Ellipsoid(const Sphere& sphere) : Sphere(sphere) {}

  bool places_hits() const override { return true; }
  Vec3 place(const ShapeRay& ray, const ShapeHit& hit) const override {
    double near, far;
    const double stretch = depths(ray, near, far);
    if (stretch == 0) return Shape::place(ray, hit);
    const double depth =
        std::abs(near / stretch - hit.t) <= std::abs(far / stretch - hit.t) ? near : far;
    return ray.origin + depth * (ray.direction * (1 / stretch));
  }
  Vec3 normal(const Vec3& p, const ShapeHit&) const override { return p - center_; }
  bool has_unit_normals() const override { return false; }
};

std::shared_ptr<const Shape> Sphere::beside_transform() const {
  return std::make_shared<Ellipsoid>(*this);
}

}  // namespace

std::shared_ptr<const Shape> make_sphere(const Vec3& center, double radius) {
  return std::make_shared<Sphere>(center, radius);
}

PlacedShape compile(const SphereNode& node, const ShapeContext&) {
  return {make_sphere(node.center, node.radius), false, {}};
}

}  // namespace durer
