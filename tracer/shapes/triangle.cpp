// triangle { <p1>, <p2>, <p3> }                                      (spec/geometry.md 13.1)
// smooth_triangle { <p1>, <n1>, <p2>, <n2>, <p3>, <n3> }             (spec/geometry.md 13.2)
#include "tracer/shapes/triangle.h"

#include <array>

#include "tracer/shapes/shape.h"

namespace durer {
namespace {

class Triangle final : public Shape {
 public:
  // Null for degenerate ones. Recomputed from the stored vertices after every transform: an
  // exchanged triangle thus turns its normal over at its first transform.
  static std::shared_ptr<const Shape> make(std::array<Vec3, 3> p, std::array<Vec3, 3> n,
                                           bool smooth) {
    auto shape = std::make_shared<Triangle>();
    const Vec3 normal = cross(p[0] - p[1], p[2] - p[1]);
    const double size = length(normal);
    shape->degenerate_ = size == 0;
    shape->normal_ = size == 0 ? normal : normal * (1 / size);
    projection_axes(shape->normal_, shape->a_, shape->b_);
    if (needs_exchange(p[0], p[1], p[2], shape->a_, shape->b_)) {
      std::swap(p[0], p[1]);
      std::swap(n[0], n[1]);
    }
    shape->p_ = p;
    shape->n_ = n;
    shape->smooth_ = smooth;
    if (smooth) {
      shape->altitude_ = altitude_of(p[0], p[1], p[2]);
      // The normals must all look to the same side of the triangle.
      int above = 0, below = 0;
      for (const Vec3& one : n) {
        const double side = dot(one, shape->normal_);
        above += side > 0;
        below += side < 0;
      }
      if (above != 3 && below != 3) shape->degenerate_ = true;
    }
    return shape;
  }

  Bounds bounds() const override {
    Bounds box{p_[0], p_[0]};
    box.extend(p_[1]);
    box.extend(p_[2]);
    return {box.min - Vec3(kGeometryEpsilon), box.max + Vec3(kGeometryEpsilon)};
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double t = depth(ray);
    if (t >= 0) out.push(t);
  }
  bool closest(const ShapeRay& ray, HitStack&, ShapeHit& hit) const override {
    const double t = depth(ray);
    if (t < kLeastHitDepth || t >= ray.t_max) return false;
    hit.t = t;
    hit.part = 0;
    return true;
  }

  bool inside(const Vec3&) const override { return false; }

  bool has_unit_normals() const override { return !smooth_; }
  Vec3 normal(const Vec3& p, const ShapeHit&) const override {
    if (!smooth_) return normal_;
    double u, v;
    smooth_weights(p_[0], p_[1], p_[2], altitude_, p, u, v);
    if (u < 1e-10) return n_[0];
    return n_[0] + u * (n_[1] - n_[0] + v * (n_[2] - n_[1]));
  }

  std::shared_ptr<const Shape> transformed(const Transform& transform) const override {
    std::array<Vec3, 3> p, n = n_;
    for (int i = 0; i < 3; ++i) p[i] = transform.point(p_[i]);
    if (smooth_) {
      // Their lengths weigh them afterwards; only a scale, which divides them, makes them unit
      // vectors again.
      const Matrix& m = transform.forward;
      const Vec3 factors{m.row[0].x, m.row[1].y, m.row[2].z};
      const bool is_scaling = transform.kind == TransformKind::scaling;
      for (Vec3& one : n) one = is_scaling ? unit_or_zero(one / factors) : transform.normal(one);
    }
    return make(p, n, smooth_);
  }

  bool is_patch() const override { return true; }
  bool is_exempt_from_box_test() const override { return true; }

 private:
  // -1: none.
  double depth(const ShapeRay& ray) const {
    if (degenerate_) return -1;
    const double slope = dot(normal_, ray.direction);
    if (std::abs(slope) < kGeometryEpsilon) return -1;
    const double t = -(dot(normal_, ray.origin) - dot(normal_, p_[0])) / slope;
    if (!(t >= 1e-6 && t <= kGreatestDepth)) return -1;
    const double s = ray.origin[a_] + t * ray.direction[a_];
    const double q = ray.origin[b_] + t * ray.direction[b_];
    return covers(p_[0], p_[1], p_[2], a_, b_, s, q) ? t : -1;
  }

  std::array<Vec3, 3> p_, n_;
  Vec3 normal_, altitude_{0};
  int a_ = 0, b_ = 1;
  bool smooth_ = false;
  bool degenerate_ = false;
};

}  // namespace

PlacedShape compile(const TriangleNode& node, const ShapeContext&) {
  return {Triangle::make(node.vertex, {Vec3(0), Vec3(0), Vec3(0)}, false), false, {}};
}

PlacedShape compile(const SmoothTriangleNode& node, const ShapeContext&) {
  std::array<Vec3, 3> normals;
  for (int i = 0; i < 3; ++i) normals[i] = unit_or_zero(node.normal[i]);
  return {Triangle::make(node.vertex, normals, true), false, {}};
}

}  // namespace durer
