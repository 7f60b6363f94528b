// disc { <center>, <normal>, radius [, hole radius] }                (spec/geometry.md 13.4)
#include <cmath>

#include "tracer/math/transform.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

// In its own frame's plane z = 0, with the transforms in the frame; its normal goes its own way.
class Disc final : public Shape {
 public:
  Disc(double radius, double hole, const Transform& frame, const Vec3& unit_normal)
      : radius_(radius),
        hole_(hole),
        outer2_(radius * radius),
        hole2_(hole * hole),
        frame_(frame),
        normal_(unit_normal) {}

  // The corners of the box in its frame, whose lower corner and edges are of single precision.
  Bounds bounds() const override {
    const float low[3] = {static_cast<float>(-radius_), static_cast<float>(-radius_), -0.001f};
    const float edge[3] = {static_cast<float>(2 * radius_), static_cast<float>(2 * radius_), 0.002f};
    Bounds box;
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 p;
      for (int i = 0; i < 3; ++i) {
        p[i] = static_cast<double>(low[i]) + (corner & (1 << i) ? static_cast<double>(edge[i]) : 0);
      }
      box.extend(frame_.point(p));
    }
    return box;
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const Vec3 o = frame_.inverse_point(ray.origin);
    Vec3 d = frame_.inverse_direction(ray.direction);
    const double stretch = length(d);
    d *= 1 / stretch;
    if (std::abs(d.z) <= kGeometryEpsilon) return;
    const double depth = -o.z / d.z;
    if (!(depth >= 0)) return;
    const double x = o.x + depth * d.x, y = o.y + depth * d.y;
    const double rho2 = x * x + y * y;
    const double t = depth / stretch;
    if (rho2 <= outer2_ && rho2 >= hole2_ && t > 1e-6 && t < kGreatestDepth) out.push(t);
  }

  // The whole half-space behind the disc.
  bool is_solid_within_bounds() const override { return false; }  // a half-space
  bool inside(const Vec3& p) const override { return frame_.inverse_point(p).z < 0; }
  Vec3 normal(const Vec3&, const ShapeHit&) const override { return normal_; }
  bool has_unit_normals() const override { return true; }

  std::shared_ptr<const Shape> transformed(const Transform& transform) const override {
    return std::make_shared<Disc>(radius_, hole_, frame_.then(transform),
                                  unit_or_zero(transform.normal(normal_)));
  }

 private:
  double radius_, hole_, outer2_, hole2_;
  Transform frame_;
  Vec3 normal_;
};

}  // namespace

PlacedShape compile(const DiscNode& node, const ShapeContext&) {
  if (node.normal == Vec3(0)) return {};
  const Transform frame =
      Transform::rotation_from_z(node.normal).then(Transform::translation(node.center));
  return {std::make_shared<Disc>(node.radius, node.hole_radius, frame, node.normal), false, {}};
}

}  // namespace durer
