// torus { major, minor [sturm] }: about the y axis                   (spec/geometry.md 12.4)
#include <cmath>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kRootElimination = 1e-4;

class Torus final : public Shape {
 public:
  explicit Torus(const TorusNode& node)
      : major_(node.major_radius), minor_(node.minor_radius), sturm_(node.sturm) {}

  Bounds bounds() const override {
    const Vec3 extent(major_ + minor_, minor_, major_ + minor_);
    return {-extent, extent};
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double stretch = length(ray.direction);
    const Vec3 d = ray.direction * (1 / stretch);
    Vec3 p = ray.origin;
    if (!meets_enclosure(p, d)) return;
    // Start near the torus: far origins cost digits.
    const double reach = major_ + minor_ + minor_;
    double closer = 0;
    const double distance2 = dot(p, p);
    if (distance2 > reach * reach) {
      closer = std::sqrt(distance2) - reach;
      p += closer * d;
    }
    // Sums and products in povray's order, to the last bit: on rims and where tori coincide those
    // decide (measured on povray 3.7).
    const double r2 = major_ * major_, minor2 = minor_ * minor_, y2 = p.y * p.y;
    const double k1 = p.x * p.x + p.z * p.z + y2 - r2 - minor2;
    const double k2 = p.x * d.x + p.z * d.z + p.y * d.y;
    const double c[5] = {1, 4 * k2, 2 * (k1 + 2 * (k2 * k2 + r2 * (d.y * d.y))),
                         4 * (k1 * k2 + 2 * r2 * (p.y * d.y)), k1 * k1 + 4 * r2 * (y2 - minor2)};
    double roots[4];
    for (int i = solve_polynomial(4, c, sturm_, kRootElimination, roots); i-- > 0;) {
      const double t = (roots[i] + closer) / stretch;
      if (t > 1e-4 && t < kGreatestDepth) out.push(t);
    }
  }

  bool inside(const Vec3& p) const override {
    const double rho = std::sqrt(p.x * p.x + p.z * p.z) - major_;
    return p.y * p.y + rho * rho <= minor_ * minor_;
  }

  Vec3 normal(const Vec3& p, const ShapeHit&) const override {
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (rho <= kGeometryEpsilon) return p;
    return p - Vec3(major_ * p.x / rho, 0, major_ * p.z / rho);
  }

  Vec2 uv(const Vec3& p, const Vec3&, const ShapeHit&) const override {
    const double rho = std::sqrt(p.x * p.x + p.z * p.z) - major_;
    return {1 - (std::atan2(p.z, p.x) + M_PI) / (2 * M_PI),
            (std::atan2(p.y, rho) + M_PI) / (2 * M_PI)};
  }

 private:
  // The ring of rectangular section around the torus must be crossed in front of the origin.
  bool meets_enclosure(const Vec3& p, const Vec3& d) const {
    const double inner = major_ - minor_, outer = major_ + minor_;
    const double inner2 = inner < 0 ? 0 : inner * inner, outer2 = outer * outer;
    const auto ahead = [](double t) { return t > kGeometryEpsilon && t < kGreatestDepth; };
    if (std::abs(d.y) > kGeometryEpsilon) {
      for (const double y : {minor_, -minor_}) {
        const double t = (y - p.y) / d.y;
        const double x = p.x + t * d.x, z = p.z + t * d.z;
        const double rho2 = x * x + z * z;
        if (rho2 >= inner2 && rho2 <= outer2 && ahead(t)) return true;
      }
    }
    const double a = d.x * d.x + d.z * d.z;
    if (a <= kGeometryEpsilon) return false;
    const double b = p.x * d.x + p.z * d.z;
    for (const double radius2 : {outer2, inner2}) {
      const double c = p.x * p.x + p.z * p.z - radius2;
      const double discriminant = b * b - a * c;
      if (discriminant < 0) continue;
      const double root = std::sqrt(discriminant);
      for (const double t : {(-b + root) / a, (-b - root) / a}) {
        const double y = p.y + t * d.y;
        if (y >= -minor_ && y <= minor_ && ahead(t)) return true;
      }
    }
    return false;
  }

  double major_, minor_;
  bool sturm_;
};

}  // namespace

PlacedShape compile(const TorusNode& node, const ShapeContext&) {
  return {std::make_shared<Torus>(node), false, {}};
}

}  // namespace durer
