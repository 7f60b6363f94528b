// ovus { bottom, top [sturm] }: two spheres joined by an arc           (spec/geometry.md 12.6)
#include <algorithm>
#include <cmath>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/shape.h"
#include "tracer/shapes/sphere.h"
#include "tracer/shapes/spherical_angle.h"

namespace durer {
namespace {

constexpr double kRootElimination = 1e-4;
constexpr double kOnArc = 1e-4;

class Ovus final : public Shape {
 public:
  explicit Ovus(const OvusNode& node)
      : bottom_(node.bottom_radius), top_(node.top_radius), sturm_(node.sturm) {
    if (bottom_ > top_) {
      arc_ = 2 * bottom_;
      height_ = 2 * top_ - bottom_ - top_ * top_ / (2 * bottom_);
      reach_ = std::sqrt(bottom_ * bottom_ - height_ * height_);
      lower_ = -height_;
      upper_ = (bottom_ - height_) * top_ / (arc_ - top_) + bottom_;
    } else {
      arc_ = 2 * top_;
      height_ = -2 * top_ + bottom_ + 1.5 * top_ * top_ / bottom_;
      reach_ = std::sqrt(top_ * top_ - (height_ - bottom_) * (height_ - bottom_));
      upper_ = 2 * bottom_ - height_;
      lower_ = -height_ * bottom_ / (arc_ - bottom_);
    }
  }

  Bounds bounds() const override {
    const double width = std::max({arc_ - reach_, bottom_, top_});
    return {{-width, -bottom_, -width}, {width, bottom_ + top_, width}};
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double scale = 1 / length(ray.direction);
    const Vec3 p = ray.origin, d = ray.direction * scale;
    int found = 0;
    sphere(p, d, 0, bottom_, 0, scale, found, out);
    if (found < 2) sphere(p, d, bottom_, top_, 1, scale, found, out);
    if (found < 2) arc(p, d, scale, out);
  }

  bool inside(const Vec3& p) const override {
    if (dot(p, p) < bottom_ * bottom_) return true;
    const Vec3 q = p - Vec3(0, bottom_, 0);
    if (dot(q, q) < top_ * top_) return true;
    return p.y > lower_ && p.y < upper_ && arc_value(p) < 0;
  }

  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override {
    if (hit.part == 0) return p / bottom_;
    if (hit.part == 1) return (p - Vec3(0, bottom_, 0)) / top_;
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    const double factor = 1 + reach_ / rho;
    return {p.x * factor, p.y - height_, p.z * factor};
  }

  Vec2 uv(const Vec3& p, const Vec3&, const ShapeHit&) const override {
    const Vec3 n = unit_or_zero(p - Vec3(0, top_ / 2, 0));
    return {spherical_angle(n.x, n.z) / (2 * M_PI), 0.5 + std::asin(n.y) / M_PI};
  }

 private:
  double arc_value(const Vec3& p) const {
    const double rho = std::sqrt(p.x * p.x + p.z * p.z) + reach_, y = p.y - height_;
    return rho * rho + y * y - arc_ * arc_;
  }

  void sphere(const Vec3& p, const Vec3& d, double center, double radius, uint32_t part,
              double scale, int& found, HitStack& out) const {
    const Vec3 to_center = Vec3(0, center, 0) - p;
    const double along = dot(to_center, d), distance2 = dot(to_center, to_center);
    if (distance2 >= radius * radius && along < kGeometryEpsilon) return;
    const double half2 = radius * radius - distance2 + along * along;
    if (half2 <= kGeometryEpsilon) return;
    const double half = std::sqrt(half2);
    for (const double t : {along - half, along + half}) {
      const double y = p.y + t * d.y;
      if (t > kGeometryEpsilon && (part == 0 ? y < lower_ : y > upper_)) {
        out.push(t * scale, part);
        ++found;
      }
    }
  }

  // The torus about the axis whose tube, of radius arc, is centred beyond the axis.
  void arc(const Vec3& p, const Vec3& d, double scale, HitStack& out) const {
    const double py = p.y - height_, r2 = reach_ * reach_;
    const double k1 = p.x * p.x + py * py + p.z * p.z - r2 - arc_ * arc_;
    const double k2 = p.x * d.x + py * d.y + p.z * d.z;
    const double c[5] = {1, 4 * k2, 2 * (k1 + 2 * (k2 * k2 + r2 * d.y * d.y)),
                         4 * (k2 * k1 + 2 * r2 * py * d.y),
                         k1 * k1 + 4 * r2 * (py * py - arc_ * arc_)};
    double roots[4];
    double kept[4];
    int count = 0;
    for (int i = solve_polynomial(4, c, sturm_, kRootElimination, roots); i-- > 0;) {
      const Vec3 at = p + roots[i] * d;
      if (roots[i] > kGeometryEpsilon && at.y > lower_ && at.y < upper_ &&
          std::abs(arc_value(at)) < kOnArc)
        kept[count++] = roots[i];
    }
    if (count > 0) out.push(kept[0] * scale, 2);
    if (count > 1) out.push(kept[count - 1] * scale, 2);
  }

  double bottom_, top_;
  double arc_, height_, reach_;  // C, V, H of the specification
  double lower_, upper_;         // where the arc ends
  bool sturm_;
};

}  // namespace

PlacedShape compile(const SphereNode& node, const ShapeContext& context);

PlacedShape compile(const OvusNode& node, const ShapeContext& context) {
  // The top sphere holds everything.
  if (node.top_radius >= 2 * node.bottom_radius)
    return compile(SphereNode{Vec3(0, node.bottom_radius, 0), node.top_radius}, context);
  return {std::make_shared<Ovus>(node), false, {}};
}

}  // namespace durer
