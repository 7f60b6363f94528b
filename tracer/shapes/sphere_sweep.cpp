// sphere_sweep { linear_spline|cubic_spline|b_spline, N, <C>, r ... [tolerance t] }
//                                                                    (spec/geometry.md 12.12)
//
// The hull of a sphere that moves along a spline and changes its radius. Candidates are the hits of
// the spheres at the segments' ends, of the discs that close the segments, and of the envelope: at
// the curve parameters u where F = |O + tD - C(u)|² - r(u)² and its derivative by u both vanish. A
// walk along the sorted candidates drops those within the solid.
//
// Candidates of one ray are collected in the shared hit stack: (u, v) of a hit holds the curve
// parameter in two floats.
#include <algorithm>
#include <cmath>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kRootEpsilon = 1e-10;
constexpr int kSideDegree = 10;  // of the envelope's equation along a cubic segment

enum Part : uint32_t { kEndSphere = 0, kStartDisc = 1, kEndDisc = 2, kSide = 3 };

// Coefficients of a product of polynomials, constant terms first.
template <size_t N, size_t M>
void add_product(const double (&a)[N], const double (&b)[M], double factor, double* sum) {
  for (size_t i = 0; i < N; ++i)
    for (size_t j = 0; j < M; ++j) sum[i + j] += factor * a[i] * b[j];
}

// Whether a polynomial (constant term first) can have a root in [0, 1]: no, if its Bernstein
// coefficients all have one sign.
bool may_vanish(const double* c, int degree) {
  // Binomials by Pascal's rule: b_i = sum over k <= i of C(i,k)/C(n,k) c_k, as repeated sums.
  double scaled[kSideDegree + 1];
  double binomial = 1;
  for (int k = 0; k <= degree; ++k) {
    scaled[k] = c[k] / binomial;
    binomial = binomial * (degree - k) / (k + 1);
  }
  bool has_positive = false, has_negative = false;
  for (int i = 0; i <= degree; ++i) {
    has_positive |= scaled[0] >= 0;
    has_negative |= scaled[0] <= 0;
    if (has_positive && has_negative) return true;
    for (int k = 0; k < degree - i; ++k) scaled[k] += scaled[k + 1];
  }
  return false;
}

struct Segment {
  int degree = 3;  // 1: linear
  // C(u) and r(u), constant terms first.
  Vec3 center[4]{Vec3(0), Vec3(0), Vec3(0), Vec3(0)};
  double radius[4]{};
  // Spheres of these enclose all of the segment's.
  Vec3 middle{0};
  double reach = 0;

  Vec3 center_at(double u) const {
    return center[0] + u * (center[1] + u * (center[2] + u * center[3]));
  }
  double radius_at(double u) const {
    return radius[0] + u * (radius[1] + u * (radius[2] + u * radius[3]));
  }
  Vec3 center_slope(double u) const {
    return center[1] + u * (2.0 * center[2] + 3 * u * center[3]);
  }
  double radius_slope(double u) const {
    return radius[1] + u * (2 * radius[2] + 3 * u * radius[3]);
  }
};

class SphereSweep final : public Shape {
 public:
  explicit SphereSweep(const SphereSweepNode& node) : node_(node) {
    const size_t count = node.centers.size();
    const size_t segments = node.spline == SplineKind::linear ? count - 1 : count - 3;
    for (size_t i = 0; i < segments; ++i) segments_.push_back(segment(i));
    for (const Segment& s : segments_) ends_.push_back({s.center_at(0), s.radius_at(0)});
    ends_.push_back({segments_.back().center_at(1), segments_.back().radius_at(1)});
  }

  Bounds bounds() const override {
    Bounds box;
    const double factor = node_.spline == SplineKind::cubic ? 2 : 1;
    for (size_t i = 0; i < node_.centers.size(); ++i) {
      // Negative radii, as after scale -1, turn the box inside out.
      const Vec3 r(factor * node_.radii[i]);
      box.min = glm::min(box.min, node_.centers[i] - r);
      box.max = glm::max(box.max, node_.centers[i] + r);
    }
    return box;
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double scale = 1 / length(ray.direction);
    const Ray unit{ray.origin, scale * ray.direction};
    const size_t first = out.size();
    find_candidates(unit, out);
    keep_outer(unit, first, out);
    size_t kept = first;
    for (size_t i = first; i < out.size(); ++i) {
      ShapeHit hit = out[i];
      hit.t *= scale;
      if (hit.t > node_.tolerance) out[kept++] = hit;
    }
    out.shrink(kept);
  }

  bool inside(const Vec3& p) const override {
    for (const Segment& s : segments_) {
      const Vec3 offset = p - s.middle;
      if (dot(offset, offset) > s.reach * s.reach) continue;
      double q[7];
      const int degree = squared_gap(s, p, q);
      double roots[kMostPolynomialDegree];
      const int count = solve(q, degree, roots);
      for (int i = 0; i < count; ++i)
        if (roots[i] >= 0 && roots[i] <= 1) return true;
    }
    return false;
  }

  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override { return normal_of(p, hit); }

  std::shared_ptr<const Shape> transformed(const Transform& transform) const override {
    const TransformKind kind = transform.kind;
    double factor = 1;
    if (kind == TransformKind::scaling) {
      const Matrix& m = transform.forward;
      if (m.row[0].x != m.row[1].y || m.row[0].x != m.row[2].z) return nullptr;
      factor = m.row[0].x;
    } else if (kind == TransformKind::general) {
      return nullptr;
    }
    SphereSweepNode moved = node_;
    for (Vec3& c : moved.centers) c = transform.point(c);
    for (double& r : moved.radii) r *= factor;
    return std::make_shared<SphereSweep>(moved);
  }

 private:
  struct EndSphere {
    Vec3 center;
    double radius;
  };

  Segment segment(size_t i) const {
    Segment s;
    const auto blend = [&](auto& c, const auto& p) {
      switch (node_.spline) {
        case SplineKind::linear:
          c[0] = p[i];
          c[1] = p[i + 1] - p[i];
          break;
        case SplineKind::cubic:
          c[0] = p[i + 1];
          c[1] = -0.5 * p[i] + 0.5 * p[i + 2];
          c[2] = p[i] - 2.5 * p[i + 1] + 2.0 * p[i + 2] - 0.5 * p[i + 3];
          c[3] = -0.5 * p[i] + 1.5 * p[i + 1] - 1.5 * p[i + 2] + 0.5 * p[i + 3];
          break;
        default:
          c[0] = (p[i] + 4.0 * p[i + 1] + p[i + 2]) / 6.0;
          c[1] = (p[i + 2] - p[i]) / 2.0;
          c[2] = (p[i] - 2.0 * p[i + 1] + p[i + 2]) / 2.0;
          c[3] = (-p[i] + 3.0 * p[i + 1] - 3.0 * p[i + 2] + p[i + 3]) / 6.0;
      }
    };
    s.degree = node_.spline == SplineKind::linear ? 1 : 3;
    blend(s.center, node_.centers);
    blend(s.radius, node_.radii);
    // The curve lies in the hull of its Bézier points.
    const auto bezier = [](const auto* c, int k) {
      switch (k) {
        case 0:
          return c[0];
        case 1:
          return c[0] + c[1] / 3.0;
        case 2:
          return c[0] + (2.0 * c[1] + c[2]) / 3.0;
        default:
          return c[0] + c[1] + c[2] + c[3];
      }
    };
    for (int k = 0; k < 4; ++k) s.middle += 0.25 * bezier(s.center, k);
    double far = 0, radius = 0;
    for (int k = 0; k < 4; ++k) {
      far = std::max(far, length(bezier(s.center, k) - s.middle));
      radius = std::max(radius, std::abs(bezier(s.radius, k)));
    }
    s.reach = (far + radius) * (1 + 1e-9);
    return s;
  }

  static int solve(const double* low_first, int degree, double* roots) {
    double c[kSideDegree + 1];
    for (int i = 0; i <= degree; ++i) c[i] = low_first[degree - i];
    return solve_polynomial(degree, c, degree > 4, kRootEpsilon, roots, kFarthestParameter);
  }

  // q(u) = |point - C(u)|² - r(u)², constant term first; returns its degree.
  static int squared_gap(const Segment& s, const Vec3& point, double (&q)[7]) {
    std::fill(std::begin(q), std::end(q), 0.0);
    Vec3 c[4] = {point - s.center[0], -s.center[1], -s.center[2], -s.center[3]};
    for (int i = 0; i <= s.degree; ++i)
      for (int j = 0; j <= s.degree; ++j) q[i + j] += dot(c[i], c[j]) - s.radius[i] * s.radius[j];
    return 2 * s.degree;
  }

  static void push(double t, uint32_t part, double u, HitStack& out) {
    if (!(t > -kGreatestDepth && t < kGreatestDepth)) return;
    const float high = static_cast<float>(u);
    out.push(t, part, high, static_cast<float>(u - static_cast<double>(high)));
  }

  static void add_sphere(const Ray& ray, const Vec3& center, double radius, uint32_t part, double u,
                         HitStack& out) {
    const Vec3 to_center = center - ray.origin;
    const double squared = dot(to_center, to_center), along = dot(to_center, ray.direction);
    const double radius2 = radius * radius;
    if (squared >= radius2 && along < kGeometryEpsilon) return;
    const double half2 = radius2 - squared + along * along;
    if (!(half2 > kGeometryEpsilon)) return;
    const double half = std::sqrt(half2);
    push(along - half, part, u, out);
    push(along + half, part, u, out);
  }

  void find_candidates(const Ray& ray, HitStack& out) const {
    for (uint32_t i = 0; i < ends_.size(); ++i)
      add_sphere(ray, ends_[i].center, ends_[i].radius, 4 * i + kEndSphere, 0, out);
    for (uint32_t i = 0; i < segments_.size(); ++i) {
      const Segment& s = segments_[i];
      const Vec3 offset = s.middle - ray.origin;
      const double along = dot(offset, ray.direction);
      if (dot(offset, offset) - along * along > s.reach * s.reach) continue;
      add_disc(ray, s, 0, 4 * i + kStartDisc, out);
      add_disc(ray, s, 1, 4 * i + kEndDisc, out);
      add_sides(ray, s, 4 * i + kSide, out);
    }
  }

  // The disc within the circle where the envelope touches an end's sphere.
  static void add_disc(const Ray& ray, const Segment& s, double u, uint32_t part, HitStack& out) {
    const Vec3 center = s.center_at(u), slope = s.center_slope(u);
    const double radius = s.radius_at(u);
    const double along = dot(ray.direction, slope);
    if (std::abs(along) <= kGeometryEpsilon) return;
    const double t = -(dot(ray.origin - center, slope) + radius * s.radius_slope(u)) / along;
    const Vec3 from_center = ray.at(t) - center;
    if (dot(from_center, from_center) < radius * radius) push(t, part, u, out);
  }

  static void add_sides(const Ray& ray, const Segment& s, uint32_t part, HitStack& out) {
    // F = t² + p(u) t + q(u).
    double q[7];
    squared_gap(s, ray.origin, q);
    double p[4] = {};
    for (int i = 0; i <= s.degree; ++i)
      p[i] = 2 * dot(ray.direction, (i == 0 ? ray.origin : Vec3(0)) - s.center[i]);
    const double p_slope[3] = {p[1], 2 * p[2], 3 * p[3]};
    const double q_slope[6] = {q[1], 2 * q[2], 3 * q[3], 4 * q[4], 5 * q[5], 6 * q[6]};
    double p2[5] = {}, pq[6] = {}, sum[kSideDegree + 1] = {};
    double roots[kMostPolynomialDegree];
    if (s.degree == 1) {
      const double slope = p[1];
      const double c[3] = {
          q[1] * q[1] - p[0] * slope * q[1] + q[0] * slope * slope,
          4 * q[1] * q[2] - slope * slope * q[1] - 2 * p[0] * slope * q[2] + q[1] * slope * slope,
          4 * q[2] * q[2] - 2 * slope * slope * q[2] + q[2] * slope * slope};
      const int count = solve(c, 2, roots);
      for (int i = 0; i < count; ++i) {
        const double u = roots[i];
        if (u < 0 || u > 1) continue;
        if (std::abs(slope) > 1e-4) {
          push(-(q[1] + 2 * q[2] * u) / slope, part, u, out);
        } else {
          add_sphere(ray, s.center_at(u), s.radius_at(u), part, u, out);
        }
      }
      return;
    }
    add_product(p_slope, p_slope, 1, p2);
    add_product(p, p_slope, 1, pq);
    add_product(q_slope, q_slope, 1, sum);
    add_product(pq, q_slope, -1, sum);
    add_product(q, p2, 1, sum);
    if (!may_vanish(sum, kSideDegree)) return;
    const int count = solve(sum, kSideDegree, roots);
    for (int i = 0; i < count; ++i) {
      const double u = roots[i];
      if (u >= 0 && u <= 1) add_sphere(ray, s.center_at(u), s.radius_at(u), part, u, out);
    }
  }

  // Sorts the candidates from `first` on and drops those between an entry and its exit.
  void keep_outer(const Ray& ray, size_t first, HitStack& out) const {
    const size_t count = out.size() - first;
    if (count == 0) return;
    std::sort(&out[first], &out[first] + count, [](const ShapeHit& a, const ShapeHit& b) {
      if (a.t != b.t) return a.t < b.t;
      if (a.part != b.part) return a.part < b.part;
      return a.u < b.u;
    });
    size_t kept = first;
    int depth = 1;
    for (size_t i = 0; i < count; ++i) {
      const ShapeHit hit = out[first + i];
      bool keep = true;
      if (i != 0 && i != count - 1) {
        if (dot(normal_of(ray.at(hit.t), hit), ray.direction) < 0) {
          keep = depth++ == 0;
        } else {
          keep = depth-- == 1;
        }
      }
      if (keep) out[kept++] = hit;
    }
    out.shrink(kept);
  }

  Vec3 normal_of(const Vec3& p, const ShapeHit& hit) const {
    const uint32_t index = hit.part / 4;
    switch (hit.part % 4) {
      case kEndSphere:
        return (p - ends_[index].center) / ends_[index].radius;
      case kStartDisc:
        return -segments_[index].center_slope(0);
      case kEndDisc:
        return segments_[index].center_slope(1);
      default: {
        const double u = static_cast<double>(hit.u) + static_cast<double>(hit.v);
        return p - segments_[index].center_at(u);
      }
    }
  }

  SphereSweepNode node_;
  std::vector<Segment> segments_;
  std::vector<EndSphere> ends_;  // of each segment's start, and of the last one's end
};

}  // namespace

PlacedShape compile(const SphereSweepNode& node, const ShapeContext&) {
  return {std::make_shared<SphereSweep>(node), false, {}};
}

}  // namespace durer
