// The quadric's numbers, for its automatic bounds (spec/geometry.md 14.2).
#pragma once

#include "tracer/shapes/shape.h"

namespace durer {

class Quadric final : public Shape {
 public:
  explicit Quadric(const QuadricNode& coefficients);

  Bounds bounds() const override { return Bounds::everything(); }
  void hits(const ShapeRay& ray, HitStack& out) const override;
  void line_hits(const ShapeRay& ray, LineHits& out) const override;
  bool closest(const ShapeRay& ray, HitStack& scratch, ShapeHit& hit) const override;
  bool inside(const Vec3& p) const override;
  // Both turn it over: the coefficients change sign and the object is marked.
  bool inside_inverted(const Vec3& p) const override { return inside(p); }
  Vec3 normal(const Vec3& p, const ShapeHit&) const override;
  std::shared_ptr<const Shape> transformed(const Transform& transform) const override;
  std::shared_ptr<const Shape> inverted() const override;
  // Ellipsoids, cylinders, paraboloids: forms of one sign. They may have no end.
  bool can_be_swept(bool is_marked) const override {
    return form_sign_ == (is_marked ? -1 : 1);
  }
  bool is_outside_of_convex() const override { return form_sign_ < 0; }

  // Whether the reference finds a box for it by itself, however large; bounded_by is then taken off a
  // top-level object.
  bool has_automatic_bounds() const;
  // Whether it has mixed terms; it has no box of its own then, whatever the range.
  bool is_aslant() const;
  // The box of the part inside `range`, by the reference's rules; false: none was found.
  bool bounds_within(const Bounds& range, Bounds& box) const;

 private:
  int depths(const ShapeRay& ray, double* t) const;
  double second_order(const Vec3& direction) const;
  bool has_form_of_sign(double sign) const;

  QuadricNode q_;
  double open_limit_;  // second_order() of unit directions along open ends is less, or less than 0
  int form_sign_;      // of second_order() in all directions where it is not about 0; 0: of both
};

}  // namespace durer
