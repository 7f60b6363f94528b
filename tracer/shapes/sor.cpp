// sor { N, <r,y>, … [open] [sturm] }: the square of the radius is a cubic of the height
//                                                                     (spec/geometry.md 12.10)
#include <algorithm>
#include <cmath>

#include "tracer/math/inverse4.h"
#include "tracer/math/polynomial.h"
#include "tracer/shapes/shape.h"
#include "tracer/shapes/spherical_angle.h"

namespace durer {
namespace {

constexpr double kLeastCapRadiusSquared = 1e-4;

// rho^2(y) = ((a y + b) y + c) y + d for bottom <= y <= top.
struct Segment {
  double a, b, c, d;
  double bottom, top;
  double greatest_radius2;

  double radius2(double y) const { return ((a * y + b) * y + c) * y + d; }
  double slope(double y) const { return (3 * a * y + 2 * b) * y + c; }
};

Segment make_segment(const Vec2* p) {
  const double y1 = p[1].y, y2 = p[2].y;
  const double v1 = p[1].x * p[1].x, v2 = p[2].x * p[2].x;
  const double slope1 = 2 * p[1].x * ((p[2].x - p[0].x) / (p[2].y - p[0].y));
  const double slope2 = 2 * p[2].x * ((p[3].x - p[1].x) / (p[3].y - p[1].y));
  // Values and slopes at both ends as sums of the coefficients; their inverse, as povray does it,
  // since on rims the last bits of the coefficients decide.
  const Matrix4 system = {{{y1 * y1 * y1, y1 * y1, y1, 1},
                           {y2 * y2 * y2, y2 * y2, y2, 1},
                           {3 * y1 * y1, 2 * y1, 1, 0},
                           {3 * y2 * y2, 2 * y2, 1, 0}}};
  Matrix4 inverse{};
  invert(system, inverse);
  const auto coefficient_of = [&](int i) {
    return inverse[i][0] * v1 + inverse[i][1] * v2 + inverse[i][2] * slope1 +
           inverse[i][3] * slope2;
  };
  Segment s{coefficient_of(0), coefficient_of(1), coefficient_of(2), coefficient_of(3), y1, y2,
            std::max(v1, v2)};
  for (double* coefficient : {&s.a, &s.b, &s.c, &s.d})
    if (std::abs(*coefficient) < kGeometryEpsilon) *coefficient = 0;
  const double derivative[3] = {3 * s.a, 2 * s.b, s.c};
  double roots[2];
  for (int i = solve_polynomial(2, derivative, false, 0, roots); i-- > 0;)
    if (roots[i] >= y1 && roots[i] <= y2)
      s.greatest_radius2 = std::max(s.greatest_radius2, s.radius2(roots[i]));
  return s;
}

class SurfaceOfRevolution final : public Shape {
 public:
  explicit SurfaceOfRevolution(const SorNode& node) : sturm_(node.sturm) {
    for (size_t i = 0; i + 4 <= node.points.size(); ++i)
      segments_.push_back(make_segment(&node.points[i]));
    double greatest = 0;
    for (const Segment& s : segments_) greatest = std::max(greatest, s.greatest_radius2);
    greatest_radius_ = std::sqrt(greatest);
    base_radius2_ = segments_.front().radius2(bottom());
    cap_radius2_ = segments_.back().radius2(top());
    has_base_ = !node.open && base_radius2_ > kLeastCapRadiusSquared;
    has_cap_ = !node.open && cap_radius2_ > kLeastCapRadiusSquared;
  }

  Bounds bounds() const override {
    return {{-greatest_radius_, bottom(), -greatest_radius_},
            {greatest_radius_, top(), greatest_radius_}};
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double stretch = length(ray.direction);
    const Vec3 d = ray.direction * (1 / stretch), p = ray.origin;
    if (std::abs(d.y) > kGeometryEpsilon) {
      if (has_base_) disc(p, d, bottom(), base_radius2_, base_part(), stretch, out);
      if (has_cap_) disc(p, d, top(), cap_radius2_, base_part() + 1, stretch, out);
    }
    const double rr = d.x * d.x + d.z * d.z, m = p.x * d.x + p.z * d.z;
    const double distance2 = p.x * p.x + p.z * p.z;
    for (size_t i = 0; i < segments_.size(); ++i) {
      const Segment& s = segments_[i];
      if (!meets_tube(s, p, d, rr, m, distance2)) continue;
      const double c[4] = {s.a * d.y * d.y * d.y, d.y * d.y * (3 * s.a * p.y + s.b) - rr,
                           d.y * (p.y * (3 * s.a * p.y + 2 * s.b) + s.c) - 2 * m,
                           s.radius2(p.y) - p.x * p.x - p.z * p.z};
      double t[3];
      const int count = solve_polynomial(3, c, sturm_, 0, t);
      for (int k = 0; k < count; ++k) {
        const double y = p.y + t[k] * d.y;
        if (y >= s.bottom && y <= s.top) push(t[k] / stretch, static_cast<uint32_t>(i), out);
      }
    }
  }

  bool inside(const Vec3& p) const override {
    if (p.y < bottom() || p.y > top()) return false;
    const double rho2 = p.x * p.x + p.z * p.z;
    if (rho2 > greatest_radius_ * greatest_radius_) return false;
    for (const Segment& s : segments_)
      if (p.y >= s.bottom && p.y <= s.top) return rho2 <= s.radius2(p.y);
    return false;
  }

  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override {
    if (hit.part == base_part()) return {0, -1, 0};
    if (hit.part > base_part()) return {0, 1, 0};
    return {p.x, -0.5 * segments_[hit.part].slope(p.y), p.z};
  }

  Vec2 uv(const Vec3& p, const Vec3&, const ShapeHit& hit) const override {
    const double u = spherical_angle(p.x, p.z) / (2 * M_PI), rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (hit.part == base_part()) return {u, rho / std::sqrt(base_radius2_) - 1};
    if (hit.part > base_part()) return {u, 2 - rho / std::sqrt(cap_radius2_)};
    const Segment& s = segments_[hit.part];
    const double v = hit.part + (p.y - s.bottom) / (s.top - s.bottom);
    return {u, v / static_cast<double>(segments_.size())};
  }

 private:
  double bottom() const { return segments_.front().bottom; }
  double top() const { return segments_.back().top; }
  uint32_t base_part() const { return static_cast<uint32_t>(segments_.size()); }

  static void push(double t, uint32_t part, HitStack& out) {
    if (t > 1e-4 && t < kGreatestDepth) out.push(t, part);
  }
  static void disc(const Vec3& p, const Vec3& d, double height, double radius2, uint32_t part,
                   double stretch, HitStack& out) {
    const double t = (height - p.y) / d.y;
    const double x = p.x + t * d.x, z = p.z + t * d.z;
    if (x * x + z * z <= radius2) push(t / stretch, part, out);
  }

  static bool meets_tube(const Segment& s, const Vec3& p, const Vec3& d, double rr, double m,
                         double distance2) {
    double from = 0, to = kGreatestDepth;
    if (std::abs(d.y) > kGeometryEpsilon) {
      const double a = (s.bottom - p.y) / d.y, b = (s.top - p.y) / d.y;
      from = std::max(from, std::min(a, b) - 1e-6);
      to = std::min(to, std::max(a, b) + 1e-6);
      if (from > to) return false;
    } else if (p.y < s.bottom - 1e-6 || p.y > s.top + 1e-6) {
      return false;
    }
    const double radius2 = s.greatest_radius2 * (1 + 1e-6) + 1e-6;
    if (rr < kGeometryEpsilon) return distance2 <= radius2;
    const double discriminant = m * m - rr * (distance2 - radius2);
    if (discriminant < 0) return false;
    const double root = std::sqrt(discriminant);
    return std::max(from, (-m - root) / rr) <= std::min(to, (-m + root) / rr);
  }

  std::vector<Segment> segments_;
  double greatest_radius_, base_radius2_, cap_radius2_;
  bool has_base_, has_cap_;
  bool sturm_;
};

}  // namespace

PlacedShape compile(const SorNode& node, const ShapeContext&) {
  if (node.points.size() < 4) return {};
  return {std::make_shared<SurfaceOfRevolution>(node), false, {}};
}

}  // namespace durer
