// box { <corner>, <corner> }                                         (spec/geometry.md 12.2)
#include <algorithm>
#include <cmath>

#include "tracer/math/transform_kind.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

// Where two faces are met this close to each other, the one that the ray meets more squarely counts.
constexpr double kEdgeTolerance = 1e-6;
constexpr int kNoSide = 6;  // sides are 2·axis, +1 for the upper face

class Box final : public Shape {
 public:
  Box(const Vec3& a, const Vec3& b) : low_(glm::min(a, b)), high_(glm::max(a, b)) {}

  Bounds bounds() const override { return {low_, high_}; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    double near, far;
    int entry, exit;
    if (!cross(ray, near, far, entry, exit)) return;
    if (near > kEdgeTolerance) out.push(near, entry);
    out.push(far, exit);
  }

  bool closest(const ShapeRay& ray, HitStack&, ShapeHit& hit) const override {
    double near, far;
    int entry, exit;
    if (!cross(ray, near, far, entry, exit)) return false;
    // At equal depths the exit, pushed last, wins.
    const bool enters = near >= kLeastHitDepth && near < far;
    hit.t = enters ? near : far;
    hit.part = enters ? entry : exit;
    return hit.t >= kLeastHitDepth && hit.t < ray.t_max;
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
    const TransformKind kind = kind_of(transform);
    if (kind != TransformKind::translation && kind != TransformKind::scaling) return nullptr;
    return std::make_shared<Box>(transform.point(low_), transform.point(high_));
  }
  bool is_exempt_from_box_test() const override { return true; }

 private:
  bool cross(const ShapeRay& ray, double& near, double& far, int& entry, int& exit) const {
    near = 0;
    far = kHugeDepth;
    entry = exit = kNoSide;
    const Vec3 steepness = glm::abs(ray.direction);
    for (int axis = 0; axis < 3; ++axis) {
      const double d = ray.direction[axis], o = ray.origin[axis];
      if (steepness[axis] <= kGeometryEpsilon) {
        if (o < low_[axis] || o > high_[axis]) return false;
        continue;
      }
      const int upper = d > 0 ? 1 : 0;
      const double t_far = ((upper ? high_ : low_)[axis] - o) / d;
      if (t_far < near) return false;
      const double t_near = ((upper ? low_ : high_)[axis] - o) / d;
      if (axis == 0) {
        if (t_far <= far) {
          exit = upper;
          far = t_far;
        }
        if (t_near >= near) {
          if (t_near > far) return false;
          entry = 1 - upper;
          near = t_near;
        }
        continue;
      }
      // On an edge the face met most squarely wins; y is always compared with x.
      if (t_far <= far - kEdgeTolerance) {
        exit = 2 * axis + upper;
        far = t_far;
      } else if (t_far <= far + kEdgeTolerance && is_steeper(axis, exit, steepness)) {
        exit = 2 * axis + upper;
      }
      if (t_near >= near + kEdgeTolerance) {
        if (t_near > far) return false;
        entry = 2 * axis + 1 - upper;
        near = t_near;
      } else if (t_near >= near - kEdgeTolerance && is_steeper(axis, entry, steepness)) {
        entry = 2 * axis + 1 - upper;
      }
    }
    return far >= kEdgeTolerance && exit != kNoSide;
  }

  static bool is_steeper(int axis, int side, const Vec3& steepness) {
    if (axis == 1) return steepness.y > steepness.x;
    return side != kNoSide && steepness.z > steepness[side / 2];
  }

  Vec3 low_, high_;
};

}  // namespace

PlacedShape compile(const BoxNode& node, const ShapeContext&) {
  return {std::make_shared<Box>(node.corner1, node.corner2), false, {}};
}

}  // namespace durer
