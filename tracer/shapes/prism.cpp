// prism { spline sweep h1, h2, N, <x,z>, … [open] [sturm] }              (spec/geometry.md 12.11)
#include <algorithm>
#include <cmath>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/profile_curve.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kSame = 1e-10;
constexpr double kSureSide = 1e-7;

bool same_point(const Vec2& a, const Vec2& b) {
  return std::abs(a.x - b.x) < kSame && std::abs(a.y - b.y) < kSame;
}

// The curve's second coordinate is z: Vec2::y below.
class Prism final : public Shape {
 public:
  Prism(const PrismNode& node, std::vector<CurveSegment> segments)
      : segments_(std::move(segments)),
        runs_(runs_of(segments_)),
        bottom_(std::min(node.height1, node.height2)),
        top_(std::max(node.height1, node.height2)),
        degree_(degree_of(node.spline)),
        conic_(node.conic_sweep),
        open_(node.open),
        sturm_(node.sturm) {
    enclose(segments_, min_, max_);
  }

  Bounds bounds() const override {
    if (!conic_) return {{min_.x, bottom_, min_.y}, {max_.x, top_, max_.y}};
    Bounds box;
    for (const double h : {bottom_, top_}) {
      box.extend(Vec3(min_.x * h, h, min_.y * h));
      box.extend(Vec3(max_.x * h, h, max_.y * h));
    }
    return box;
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double stretch = length(ray.direction);
    const Vec3 d = ray.direction * (1 / stretch);
    if (conic_) {
      conic_hits(ray.origin, d, stretch, out);
    } else {
      linear_hits(ray.origin, d, stretch, out);
    }
  }

  bool inside(const Vec3& p) const override {
    if (p.y < bottom_ || p.y >= top_) return false;
    if (!conic_) return covers(p.x, p.z);
    return std::abs(p.y) > kGeometryEpsilon && covers(p.x / p.y, p.z / p.y);
  }

  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override {
    if (hit.part >= segments_.size()) return {0, 1, 0};
    const Vec2 tangent = segments_[hit.part].tangent(hit.parameter());
    Vec3 n(tangent.y, 0, -tangent.x);
    if (conic_ && std::abs(p.y) > kGeometryEpsilon) n.y = -(p.x * n.x + p.z * n.z) / p.y;
    return n;
  }

 private:
  void push(double local_t, double stretch, size_t part, double w, HitStack& out) const {
    const double t = local_t / stretch;
    if (t > 1e-4 && t < kGreatestDepth) out.push_with_parameter(t, static_cast<uint32_t>(part), w);
  }

  void cap(const Vec3& p, const Vec3& d, double height, double stretch, HitStack& out) const {
    const double t = (height - p.y) / d.y;
    if (!(t > 1e-4 && t < kGreatestDepth)) return;
    const double size = conic_ ? 1 / height : 1;
    if (covers((p.x + t * d.x) * size, (p.z + t * d.z) * size))
      push(t, stretch, segments_.size(), 0, out);
  }

  void linear_hits(const Vec3& p, const Vec3& d, double stretch, HitStack& out) const {
    const bool level = std::abs(d.y) < kGeometryEpsilon;
    if (level && (p.y < bottom_ || p.y > top_)) return;
    if (!open_ && !level) {
      cap(p, d, top_, stretch, out);
      cap(p, d, bottom_, stretch, out);
    }
    if (std::abs(d.x) < kGeometryEpsilon && std::abs(d.z) < kGeometryEpsilon) return;
    const Rectangle way = way_between_caps(p, d);
    for_each_met(d.z, -d.x, d.x * p.z - d.z * p.x, way, [&](const CurveSegment& s, size_t i) {
      double w[3];
      const int count = solve_line(s, d.z, -d.x, s.constant - Vec2(p.x, p.z), 0, w);
      for (int k = 0; k < count; ++k) {
        if (w[k] < 0 || w[k] > 1) continue;
        const Vec2 at = s.point(w[k]);
        const double t = std::abs(d.x) > kGeometryEpsilon ? (at.x - p.x) / d.x : (at.y - p.z) / d.z;
        const double y = p.y + t * d.y;
        if (y >= bottom_ && y <= top_) push(t, stretch, i, w[k], out);
      }
    });
  }

  void conic_hits(const Vec3& p, const Vec3& d, double stretch, HitStack& out) const {
    if (!open_ && std::abs(d.y) >= kGeometryEpsilon) {
      if (std::abs(top_) > kGeometryEpsilon) cap(p, d, top_, stretch, out);
      if (std::abs(bottom_) > kGeometryEpsilon) cap(p, d, bottom_, stretch, out);
    }
    // Rays along the axis meet the caps only, as in POV-Ray.
    if (std::abs(d.x) < kGeometryEpsilon && std::abs(d.z) < kGeometryEpsilon) return;
    const double k1 = p.z * d.y - p.y * d.z, k2 = p.y * d.x - p.x * d.y, k3 = p.x * d.z - p.z * d.x;
    for_each_met(k1, k2, k3, Rectangle(), [&](const CurveSegment& s, size_t i) {
      double w[3];
      const int count = solve_line(s, k1, k2, s.constant, k3, w);
      for (int k = 0; k < count; ++k) {
        if (w[k] < 0 || w[k] > 1) continue;
        const Vec2 at = s.point(w[k]);
        double t;
        if (const double by_x = d.x - at.x * d.y; std::abs(by_x) > kGeometryEpsilon) {
          t = (at.x * p.y - p.x) / by_x;
        } else if (const double by_z = d.z - at.y * d.y; std::abs(by_z) > kGeometryEpsilon) {
          t = (at.y * p.y - p.z) / by_z;
        } else {
          continue;
        }
        const double y = p.y + t * d.y;
        if (y >= bottom_ && y <= top_) push(t, stretch, i, w[k], out);
      }
    });
  }

  struct Rectangle {
    Vec2 min{-HUGE_VAL}, max{HUGE_VAL};

    bool overlaps(const Vec2& low, const Vec2& high) const {
      return low.x <= max.x && high.x >= min.x && low.y <= max.y && high.y >= min.y;
    }
  };
  // Where the sides may be met, a little more: hits beyond are not pushed.
  Rectangle way_between_caps(const Vec3& p, const Vec3& d) const {
    // Of rays along an axis the depths are found less exactly.
    const bool is_exact = std::abs(d.x) > 1e-4 && std::abs(d.y) > 1e-4;
    if (!is_exact) return {};
    const double a = (bottom_ - p.y) / d.y, b = (top_ - p.y) / d.y;
    const double from = std::max(0.0, std::min(a, b)), to = std::max(0.0, std::max(a, b));
    const Vec2 start(p.x + from * d.x, p.z + from * d.z), end(p.x + to * d.x, p.z + to * d.z);
    const Vec2 slack = 1e-6 * (1.0 + glm::abs(start) + glm::abs(end) + Vec2(to));
    return {glm::min(start, end) - slack, glm::max(start, end) + slack};
  }

  // visit(segment, number) for those whose rectangles touch the line x k1 + z k2 + k3 = 0 of the plane,
  // and the way, in order.
  template <typename Visit>
  void for_each_met(double k1, double k2, double k3, const Rectangle& way, Visit&& visit) const {
    const auto is_met = [&](const Vec2& min, const Vec2& max) {
      return way.overlaps(min, max) && line_meets_box(min, max, k1, k2, k3);
    };
    for (const CurveRun& run : runs_) {
      if (!is_met(run.min, run.max)) continue;
      for (size_t i = run.first; i < run.end; ++i) {
        const CurveSegment& s = segments_[i];
        if (is_met(s.min, s.max)) visit(s, i);
      }
    }
  }
  static bool line_meets_box(const Vec2& min, const Vec2& max, double k1, double k2, double k3) {
    const double low = std::min(k1 * min.x, k1 * max.x) + std::min(k2 * min.y, k2 * max.y);
    const double high = std::max(k1 * min.x, k1 * max.x) + std::max(k2 * min.y, k2 * max.y);
    const double slack = 1e-9 * (std::abs(low) + std::abs(high) + std::abs(k3));
    return low + k3 <= slack && high + k3 >= -slack;
  }

  // Of x k1 + z k2 + k3, where `start` is the curve's first point; a linear sweep's is seen from
  // the ray, which gives povray's last digits.
  int solve_line(const CurveSegment& s, double k1, double k2, const Vec2& start, double k3,
                 double* w) const {
    const double c[4] = {s.cubic.x * k1 + s.cubic.y * k2, s.square.x * k1 + s.square.y * k2,
                         s.linear.x * k1 + s.linear.y * k2, start.x * k1 + start.y * k2 + k3};
    if (degree_ == 1) {
      if (std::abs(c[2]) <= kGeometryEpsilon) return 0;
      w[0] = -c[3] / c[2];
      return 1;
    }
    return solve_polynomial(degree_, c + 3 - degree_, sturm_ && degree_ == 3, 0, w,
                            kFarthestParameter);
  }

  // Odd number of crossings of the curve along +x.
  bool covers(double x, double z) const {
    bool inside = false;
    const auto is_passed = [&](const Vec2& min, const Vec2& max) {
      return z < min.y || z > max.y || x > max.x;
    };
    for (const CurveRun& run : runs_) {
      if (is_passed(run.min, run.max)) continue;
      for (size_t k = run.first; k < run.end; ++k) {
        const CurveSegment& s = segments_[k];
        if (is_passed(s.min, s.max)) continue;
        if (x < s.min.x) {
          // All crossings count: they are odd in number if the ends lie on two sides.
          const double before = s.constant.y - z;
          const double after = before + s.linear.y + s.square.y + s.cubic.y;
          if (std::min(std::abs(before), std::abs(after)) > kSureSide) {
            inside ^= (before < 0) != (after < 0);
            continue;
          }
        }
        double w[3];
        for (int i = solve_coordinate(s, degree_, 1, z, sturm_, w); i-- > 0;)
          if (s.point(w[i]).x >= x) inside = !inside;
      }
    }
    return inside;
  }

  std::vector<CurveSegment> segments_;
  std::vector<CurveRun> runs_;
  double bottom_, top_;
  int degree_;
  bool conic_, open_, sturm_;
  Vec2 min_, max_;
};

// Splits the points into closed curves, and those into segments. Empty: not closed.
std::vector<CurveSegment> make_segments(const PrismNode& node) {
  std::vector<Vec2> p = node.points;
  std::vector<CurveSegment> segments;
  const auto add = [&](const Vec2* points) {
    segments.push_back(curve_segment(node.spline, points, true));
  };
  switch (node.spline) {
    case SplineKind::linear: {
      size_t first = 0;
      for (size_t i = 1; i < p.size(); ++i) {
        add(&p[i - 1]);
        if (same_point(p[i], p[first])) first = ++i;
      }
      if (first < p.size()) {
        const Vec2 closing[2] = {p.back(), p[first]};
        add(closing);
      }
      break;
    }
    case SplineKind::quadratic:
    case SplineKind::cubic: {
      // A curve starts and ends at the second of its points.
      const size_t control = node.spline == SplineKind::quadratic ? 3 : 4;
      size_t start = 1;
      bool closed = false;
      for (size_t i = 0; i + control <= p.size();) {
        add(&p[i]);
        closed = same_point(p[i + 2], p[start]);
        if (closed) {
          i += control;
          start = i + 1;
        } else {
          ++i;
        }
      }
      if (!closed) return {};
      break;
    }
    default: {
      size_t first = 0;
      for (size_t i = 0; i + 4 <= p.size(); i += 4) {
        if (i > first && !same_point(p[i], p[i - 1])) {
          if (!same_point(p[i - 1], p[first])) return {};
          first = i;
        }
        add(&p[i]);
      }
      if (p.size() < 4 || !same_point(p[p.size() - 1], p[first])) return {};
    }
  }
  return segments;
}

}  // namespace

PlacedShape compile(const PrismNode& node, const ShapeContext&) {
  std::vector<CurveSegment> segments = make_segments(node);
  if (segments.empty()) return {};
  return {std::make_shared<Prism>(node, std::move(segments)), false, {}};
}

}  // namespace durer
