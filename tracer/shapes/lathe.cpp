// lathe { spline N, <r,y>, … [sturm] }: a curve turned about the y axis   (spec/geometry.md 12.9)
#include <algorithm>
#include <cmath>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/profile_curve.h"
#include "tracer/shapes/shape.h"
#include "tracer/shapes/spherical_angle.h"

namespace durer {
namespace {

class Lathe final : public Shape {
 public:
  Lathe(const LatheNode& node, std::vector<CurveSegment> segments)
      : segments_(std::move(segments)),
        runs_(runs_of(segments_)),
        degree_(degree_of(node.spline)),
        sturm_(node.sturm) {
    enclose(segments_, min_, max_);
  }

  Bounds bounds() const override {
    const double radius = std::max(std::abs(min_.x), std::abs(max_.x));
    return {{-radius, min_.y, -radius}, {radius, max_.y, radius}};
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double size = length(ray.direction), scale = 1 / size;
    const Vec3 d = ray.direction * scale, p = ray.origin;
    const double rr = d.x * d.x + d.z * d.z, m = d.x * p.x + d.z * p.z;
    const double distance2 = p.x * p.x + p.z * p.z;
    for (const CurveRun& run : runs_) {
      if (!meets_tube(run.min, run.max, p, d, rr, m, distance2)) continue;
      for (size_t i = run.first; i < run.end; ++i) {
        const CurveSegment& s = segments_[i];
        if (!meets_tube(s.min, s.max, p, d, rr, m, distance2)) continue;
        double w[6];
        const int count = solve_profile(s, p, d, rr, m, distance2, w);
        for (int k = 0; k < count; ++k) {
          if (w[k] < 0 || w[k] > 1) continue;
          const Vec2 at = s.point(w[k]);
          if (std::abs(d.y) > kGeometryEpsilon) {
            push((at.y - p.y) / (d.y * size), i, w[k], out);
          } else {
            const double c[3] = {rr, 2 * m, distance2 - at.x * at.x};
            double t[2];
            for (int n = 0, found = solve_quadratic(c, t); n < found; ++n)
              push(t[n] * scale, i, w[k], out);
          }
        }
      }
    }
  }

  // The segments are tried one after the other, the one that is entered first first.
  bool ends_at_nearest_hit() const override { return segments_.size() > 1; }

  // Odd number of crossings from the point outwards. An open profile counts as closed at the axis.
  bool inside(const Vec3& p) const override {
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (p.y < min_.y || p.y > max_.y || rho < min_.x || rho > max_.x) return false;
    bool inside = false;
    const auto is_beside = [&](const Vec2& min, const Vec2& max) {
      return p.y < min.y - kGeometryEpsilon || p.y > max.y + kGeometryEpsilon;
    };
    for (const CurveRun& run : runs_) {
      if (is_beside(run.min, run.max)) continue;
      for (size_t k = run.first; k < run.end; ++k) {
        const CurveSegment& s = segments_[k];
        if (is_beside(s.min, s.max)) continue;
        double w[3];
        for (int i = solve_coordinate(s, degree_, 1, p.y, sturm_, w); i-- > 0;)
          if (s.point(w[i]).x >= rho) inside = !inside;
      }
    }
    return inside;
  }

  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override {
    const double rho2 = p.x * p.x + p.z * p.z;
    if (rho2 <= kGeometryEpsilon) return {0, 1, 0};
    const Vec2 tangent = segments_[hit.part].tangent(hit.parameter());
    return {tangent.y * p.x, -tangent.x * std::sqrt(rho2), tangent.y * p.z};
  }

  Vec2 uv(const Vec3& p, const Vec3&, const ShapeHit& hit) const override {
    const double v = (hit.parameter() + hit.part) / static_cast<double>(segments_.size());
    return {spherical_angle(p.x, p.z) / (2 * M_PI), std::min(1.0, v)};
  }

 private:
  static void push(double t, size_t segment, double w, HitStack& out) {
    if (t > 1e-4 && t < kGreatestDepth)
      out.push_with_parameter(t, static_cast<uint32_t>(segment), w);
  }

  // The ray must cross the tube of segments within this rectangle: its heights, and its outer radius.
  static bool meets_tube(const Vec2& min, const Vec2& max, const Vec3& p, const Vec3& d, double rr,
                         double m, double distance2) {
    double from = 0, to = kGreatestDepth;
    if (std::abs(d.y) > kGeometryEpsilon) {
      const double a = (min.y - p.y) / d.y, b = (max.y - p.y) / d.y;
      from = std::max(from, std::min(a, b) - 1e-6);
      to = std::min(to, std::max(a, b) + 1e-6);
      if (from > to) return false;
    } else if (p.y < min.y - 1e-6 || p.y > max.y + 1e-6) {
      return false;
    }
    const double radius = std::max(std::abs(min.x), std::abs(max.x)) + 1e-6;
    if (rr < kGeometryEpsilon) return distance2 <= radius * radius;
    const double discriminant = m * m - rr * (distance2 - radius * radius);
    if (discriminant < 0) return false;
    const double root = std::sqrt(discriminant);
    if (std::max(from, (-m - root) / rr) > std::min(to, (-m + root) / rr)) return false;
    // All of the way below the inner radius?
    const double inner = std::min(min.x, max.x) - 1e-6;
    if (inner <= 0) return true;
    const auto within = [&](double t) { return distance2 + t * (2 * m + t * rr) < inner * inner; };
    return !(within(from) && within(to));
  }

  // Roots w of r2 (y - Py)^2 + 2 m dy (y - Py) + dy^2 (Px^2 + Pz^2 - x^2). Products and sums are
  // grouped as povray's are, whose last bits decide where two roots nearly coincide (measured on
  // povray 3.7).
  int solve_profile(const CurveSegment& s, const Vec3& p, const Vec3& d, double rr, double m,
                    double distance2, double* roots) const {
    const Vec2 &a = s.cubic, &b = s.square, &c = s.linear;
    const double x = s.constant.x, y = s.constant.y - p.y, dy2 = d.y * d.y;
    const double low[3] = {
        rr * (2 * b.y * y + c.y * c.y) + 2 * b.y * d.y * m - dy2 * (2 * b.x * x + c.x * c.x),
        2 * (c.y * (rr * y + m * d.y) - c.x * x * dy2),
        y * (rr * y + 2 * m * d.y) + dy2 * (distance2 - x * x)};
    switch (degree_) {
      case 1: {
        const double k[3] = {c.y * c.y * rr - c.x * c.x * dy2, low[1], low[2]};
        return solve_polynomial(2, k, false, 0, roots);
      }
      case 2: {
        const double k[5] = {b.y * b.y * rr - b.x * b.x * dy2,
                             2 * (b.y * c.y * rr - b.x * c.x * dy2), low[0], low[1], low[2]};
        return solve_polynomial(4, k, sturm_, 0, roots, kFarthestParameter);
      }
      default: {
        const double k[7] = {a.y * a.y * rr - a.x * a.x * dy2,
                             2 * (a.y * b.y * rr - a.x * b.x * dy2),
                             (2 * a.y * c.y + b.y * b.y) * rr - (2 * a.x * c.x + b.x * b.x) * dy2,
                             2 * ((b.y * c.y + a.y * s.constant.y - a.y * p.y) * rr +
                                  a.y * d.y * m - (a.x * x + b.x * c.x) * dy2),
                             low[0],
                             low[1],
                             low[2]};
        return solve_polynomial(6, k, sturm_, 0, roots, kFarthestParameter);
      }
    }
  }

  std::vector<CurveSegment> segments_;
  std::vector<CurveRun> runs_;
  int degree_;
  bool sturm_;
  Vec2 min_, max_;
};

}  // namespace

PlacedShape compile(const LatheNode& node, const ShapeContext&) {
  const size_t per_segment = static_cast<size_t>(degree_of(node.spline)) + 1;
  const size_t step = node.spline == SplineKind::bezier ? 4 : 1;
  std::vector<CurveSegment> segments;
  for (size_t i = 0; i + per_segment <= node.points.size(); i += step)
    segments.push_back(curve_segment(node.spline, &node.points[i], false));
  if (segments.empty()) return {};
  return {std::make_shared<Lathe>(node, std::move(segments)), false, {}};
}

}  // namespace durer
