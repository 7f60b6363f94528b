// The plane's numbers, for boxes of intersections (spec/geometry.md 14.1).
#pragma once

#include "tracer/shapes/shape.h"

namespace durer {

class Plane final : public Shape {
 public:
  // n·p = d; the normal must be of unit length.
  Plane(const Vec3& unit_normal, double distance) : normal_(unit_normal), distance_(distance) {}

  Bounds bounds() const override { return Bounds::everything(); }
  void hits(const ShapeRay& ray, HitStack& out) const override;
  void line_hits(const ShapeRay& ray, LineHits& out) const override;
  bool closest(const ShapeRay& ray, HitStack& scratch, ShapeHit& hit) const override;
  bool inside(const Vec3& p) const override;
  Vec3 normal(const Vec3&, const ShapeHit&) const override { return normal_; }
  bool has_unit_normals() const override { return true; }
  std::shared_ptr<const Shape> transformed(const Transform& transform) const override;
  std::shared_ptr<const Shape> inverted() const override;
  bool takes_inverse_mark() const override { return false; }
  bool is_exempt_from_box_test() const override { return true; }
  bool is_half_space() const override { return true; }

  const Vec3& unit_normal() const { return normal_; }
  double distance() const { return distance_; }

 private:
  Vec3 normal_;
  double distance_;
};

}  // namespace durer
