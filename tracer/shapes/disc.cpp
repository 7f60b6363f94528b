// disc { <center>, <normal>, radius [, hole radius] }                (spec/geometry.md 13.4)
#include <cmath>

#include "tracer/math/transform.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

class Disc final : public Shape {
 public:
  Disc(double radius, double hole) : radius_(radius), outer2_(radius * radius), hole2_(hole * hole) {}

  Bounds bounds() const override {
    return {{-radius_, -radius_, -0.001}, {radius_, radius_, 0.001}};
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double stretch = length(ray.direction);
    const Vec3 d = ray.direction * (1 / stretch);
    if (std::abs(d.z) <= kGeometryEpsilon) return;
    const double depth = -ray.origin.z / d.z;
    if (!(depth >= 0)) return;
    const double x = ray.origin.x + depth * d.x, y = ray.origin.y + depth * d.y;
    const double rho2 = x * x + y * y;
    const double t = depth / stretch;
    if (rho2 <= outer2_ && rho2 >= hole2_ && t > 1e-6 && t < kGreatestDepth) out.push(t);
  }

  // The whole half-space behind the disc.
  bool is_solid_within_bounds() const override { return false; }  // a half-space
  bool inside(const Vec3& p) const override { return p.z < 0; }
  Vec3 normal(const Vec3&, const ShapeHit&) const override { return {0, 0, 1}; }

 private:
  double radius_, outer2_, hole2_;
};

}  // namespace

PlacedShape compile(const DiscNode& node, const ShapeContext&) {
  const Vec3 normal = normalize_or_zero(node.normal);
  if (normal == Vec3(0)) return {};
  return {std::make_shared<Disc>(node.radius, node.hole_radius), true,
          Transform::rotation_from_z(normal).then(Transform::translation(node.center))};
}

}  // namespace durer
