// box { <corner>, <corner> }                                         (spec/geometry.md 12.2)
#include <algorithm>

#include "tracer/shapes/box_crossing.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kLeastEntry = 1e-6;

class Box final : public Shape {
 public:
  Box(const Vec3& a, const Vec3& b) : low_(glm::min(a, b)), high_(glm::max(a, b)) {}

  Bounds bounds() const override { return {low_, high_}; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    LineHits met;
    line_hits(ray, met);
    met.push_to(out);
  }

  void line_hits(const ShapeRay& ray, LineHits& out) const override {
    BoxCrossing crossing;
    if (!cross_box(low_, high_, ray, crossing)) return;
    const auto& [near, far, entry, exit] = crossing;
    if (near > kLeastEntry) out.add(near, entry);
    out.add(far, exit);
  }

  bool closest(const ShapeRay& ray, HitStack&, ShapeHit& hit) const override {
    BoxCrossing crossing;
    if (!cross_box(low_, high_, ray, crossing)) return false;
    const auto& [near, far, entry, exit] = crossing;
    // At equal depths the exit, pushed last, wins.
    const bool enters = near >= kLeastHitDepth && near < far;
    const double t = enters ? near : far;
    if (!(t >= kLeastHitDepth && t < ray.t_max)) return false;
    hit.t = t;
    hit.part = enters ? entry : exit;
    return true;
  }

  bool inside(const Vec3& p) const override {
    return p.x >= low_.x && p.x <= high_.x && p.y >= low_.y && p.y <= high_.y && p.z >= low_.z &&
           p.z <= high_.z;
  }

  Vec3 normal(const Vec3&, const ShapeHit& hit) const override {
    Vec3 n(0);
    n[hit.part / 2] = hit.part % 2 ? 1 : -1;
    return n;
  }

  Vec2 uv(const Vec3& point, const Vec3&, const ShapeHit& hit) const override {
    const Vec3 p = (point - low_) / (high_ - low_);
    switch (hit.part) {
      case 0: return {p.z / 4, (1 + p.y) / 3};
      case 1: return {0.75 - p.z / 4, (1 + p.y) / 3};
      case 2: return {0.25 + p.x / 4, p.z / 3};
      case 3: return {0.25 + p.x / 4, 1 - p.z / 3};
      case 4: return {1 - p.x / 4, (1 + p.y) / 3};
      default: return {0.25 + p.x / 4, (1 + p.y) / 3};
    }
  }

  std::shared_ptr<const Shape> transformed(const Transform& transform) const override {
    const TransformKind kind = transform.kind;
    if (kind != TransformKind::translation && kind != TransformKind::scaling) return nullptr;
    return std::make_shared<Box>(transform.point(low_), transform.point(high_));
  }
  bool is_exempt_from_box_test() const override { return true; }
  bool is_convex_solid() const override { return true; }
  bool is_quickly_missed() const override { return true; }

 private:

  Vec3 low_, high_;
};

}  // namespace

PlacedShape compile(const BoxNode& node, const ShapeContext&) {
  return {std::make_shared<Box>(node.corner1, node.corner2), false, {}};
}

}  // namespace durer
