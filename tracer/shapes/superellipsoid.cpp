// superellipsoid { <e, n> }                                            (spec/geometry.md 12.5)
#include <algorithm>
#include <cmath>

#include "tracer/math/power.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kHalfCube = 1.01;
constexpr double kLeastDepth = 1e-4;
constexpr int kMostSteps = 20;
constexpr int kMostSamples = 16;
// A bound above this much is no rounding error; samples nearer to each other tell nothing of a slope.
constexpr double kSureValue = 1e-6, kLeastSpacing = 1e-6;

// (a^E + b^E)^(1/E) without overflow.
double combine(double a, double b, double exponent) {
  const double larger = std::max(a, b), smaller = std::min(a, b);
  if (larger == 0) return 0;
  const double sum = 1 + power(smaller / larger, exponent);
  return sum == 1 ? larger : larger * power(sum, 1 / exponent);
}

class Superellipsoid final : public Shape {
 public:
  explicit Superellipsoid(const Vec2& exponents)
      : e_(2 / exponents.x),
        n_(2 / exponents.y),
        is_convex_(e_ >= 1 && n_ >= 1),
        surely_outside_(power(1 + kSureValue, n_)) {}

  Bounds bounds() const override { return {Vec3(-1.0001), Vec3(1.0001)}; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double scale = 1 / length(ray.direction);
    const Vec3 p = ray.origin, d = ray.direction * scale;
    double entry, exit;
    if (!clip_to_cube(p, d, entry, exit)) return;
    if (is_convex_ && entry == kLeastDepth && leaves(p + entry * d, d)) return;
    Samples samples;
    sample_distances(p, d, entry, exit, samples);
    const auto sample = [&](int i) {
      if (i == samples.known) samples.f[samples.known++] = value(p + samples.t[i] * d);
      return samples.f[i];
    };
    double left = samples.t[0], f_left = sample(0);
    if (std::abs(f_left) < kGeometryEpsilon && push(left * scale, out) && !ray.csg_child) return;
    for (int i = 1; i < samples.count; ++i) {
      const double right = samples.t[i], f_right = sample(i);
      if (std::abs(f_right) < kGeometryEpsilon) {
        if (push(right * scale, out) && !ray.csg_child) return;
      } else {
        double t = 0;
        bool found = false;
        if (f_left * f_right < 0) {
          t = find_root(p, d, left, f_left, right, f_right);
          found = true;
        } else {
          if (is_convex_ && i + 1 < samples.count) sample(i + 1);
          found = !(is_convex_ && stays_outside(samples, i)) &&
                  approach(p, d, left, f_left, right, t);
        }
        if (found && push(t * scale, out) && !ray.csg_child) return;
      }
      left = right;
      f_left = f_right;
    }
  }

  bool inside(const Vec3& p) const override { return value(p) < kGeometryEpsilon; }

  Vec3 normal(const Vec3& p, const ShapeHit&) const override {
    const double x = std::abs(p.x), y = std::abs(p.y), z = std::abs(p.z);
    const double a = power(z, n_);
    Vec3 n(0);
    if (z > 0) n.z = a / p.z;
    double ratio;
    if (x > y) {
      ratio = power(y / x, e_);
      n.x = (1 - a) / p.x;
      if (p.y != 0) n.y = (1 - a) * ratio / p.y;
    } else {
      ratio = y > 0 ? power(x / y, e_) : 0;
      if (p.x != 0) n.x = (1 - a) * ratio / p.x;
      if (p.y != 0) n.y = (1 - a) / p.y;
    }
    if (n.z != 0) n.z *= 1 + ratio;
    return n;
  }

 private:
  // Depths on a ray, ascending, and the values there, as far as they are known.
  struct Samples {
    int count = 0, known = 0;
    double t[kMostSamples], f[kMostSamples];
  };

  // A norm, less 1: convex where both exponents are at least 1.
  double value(const Vec3& p) const {
    return combine(combine(std::abs(p.x), std::abs(p.y), e_), std::abs(p.z), n_) - 1;
  }

  // Whether a ray that starts here, outside, never comes nearer: as the norm is convex, its slope says so.
  bool leaves(const Vec3& p, const Vec3& d) const {
    const double x = power(std::abs(p.x), e_), y = power(std::abs(p.y), e_);
    const double z = power(std::abs(p.z), n_), r = power(x + y, n_ / e_);
    if (!(r + z > surely_outside_)) return false;
    const auto slope = [](double term, double place, double along) {
      return place != 0 ? term / place * along : 0;
    };
    const double across = x + y > 0 ? r / (x + y) : 0;
    return across * (slope(x, p.x, d.x) + slope(y, p.y, d.y)) + slope(z, p.z, d.z) > 0;
  }

  static bool push(double t, HitStack& out) {
    if (!(t > kLeastDepth && t < kGreatestDepth)) return false;
    out.push(t);
    return true;
  }

  static bool clip_to_cube(const Vec3& p, const Vec3& d, double& entry, double& exit) {
    entry = 0;
    exit = kGreatestDepth;
    for (int i = 0; i < 3; ++i) {
      if (std::abs(d[i]) < kGeometryEpsilon) {
        if (std::abs(p[i]) > kHalfCube) return false;
        continue;
      }
      const double a = (-kHalfCube - p[i]) / d[i], b = (kHalfCube - p[i]) / d[i];
      entry = std::max(entry, std::min(a, b));
      exit = std::min(exit, std::max(a, b));
    }
    if (exit < entry || exit < kLeastDepth) return false;
    entry = std::max(entry, kLeastDepth);
    return exit >= entry;
  }

  // Entry, exit and the crossings of the planes where the surface may be sharp, ascending.
  static void sample_distances(const Vec3& p, const Vec3& d, double entry, double exit,
                               Samples& samples) {
    static constexpr double kPlanes[9][3] = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1},
                                             {0, 1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    samples.t[samples.count++] = entry;
    samples.t[samples.count++] = exit;
    const double slack = kGeometryEpsilon * (exit - entry);
    for (const auto& plane : kPlanes) {
      const Vec3 n(plane[0], plane[1], plane[2]);
      const double along = dot(n, d);
      if (std::abs(along) < kGeometryEpsilon) continue;
      const double t = -dot(n, p) / along;
      if (t >= entry - slack && t <= exit + slack) samples.t[samples.count++] = t;
    }
    std::sort(samples.t, samples.t + samples.count);
  }

  // Between samples i - 1 and i, both outside: a convex function lies above the chords beside it.
  static bool stays_outside(const Samples& samples, int i) {
    const double *t = samples.t, *f = samples.f;
    if (!(f[i - 1] > kSureValue && f[i] > kSureValue)) return false;
    // The chord from `far` to `near`, drawn on to the other end.
    const auto is_above = [&](int far, int near, int end) {
      const double spacing = t[near] - t[far];
      return std::abs(spacing) > kLeastSpacing &&
             f[near] + (f[near] - f[far]) * (t[end] - t[near]) / spacing > kSureValue;
    };
    return (i >= 2 && is_above(i - 2, i - 1, i)) ||
           (i + 1 < samples.count && is_above(i + 1, i, i - 1));
  }

  // Chord and midpoint by turns; 20 rounds. Quicker ways lead to other last digits, which show at
  // the edges of sharp ones.
  double find_root(const Vec3& p, const Vec3& d, double a, double fa, double b, double fb) const {
    for (int i = 0; i < kMostSteps; ++i) {
      if (std::abs(fa) < kGeometryEpsilon) return a;
      if (std::abs(fb) < kGeometryEpsilon) return b;
      double chord = a - fa * (b - a) / (fb - fa), middle = 0.5 * (a + b);
      double f_chord = value(p + chord * d), f_middle = value(p + middle * d);
      if (f_chord * f_middle < 0) {
        if (f_chord * fa > 0) {
          a = chord, fa = f_chord, b = middle, fb = f_middle;
        } else {
          a = middle, fa = f_middle, b = chord, fb = f_chord;
        }
      } else {
        if (std::abs(f_middle) < std::abs(f_chord)) chord = middle, f_chord = f_middle;
        if (f_chord * fa > 0) {
          a = chord, fa = f_chord;
        } else {
          b = chord, fb = f_chord;
        }
      }
    }
    return std::abs(fa) < std::abs(fb) ? a : b;
  }

  // Both ends have the same sign: secant steps towards a zero between them.
  bool approach(const Vec3& p, const Vec3& d, double left, double f_left, double right,
                double& t) const {
    const double length = right - left;
    double at = left, f = f_left, step = 1e-4 * length;
    for (int i = 0; i < kMostSteps; ++i) {
      const double next = at + step;
      if (step > length || next > right || step == 0) return false;
      const double f_next = value(p + next * d);
      if (std::abs(f_next) < kGeometryEpsilon) {
        t = next;
        return true;
      }
      if (f_next * f < 0) {
        t = find_root(p, d, at, f, next, f_next);
        return true;
      }
      if (std::abs(f_next) > std::abs(f) || f_next == f) return false;
      const double secant = next - f_next * (next - at) / (f_next - f);
      at = next;
      f = f_next;
      step = secant - at;
      if (step < 0) return false;
    }
    return false;
  }

  double e_, n_;
  bool is_convex_;
  double surely_outside_;  // norm to the power n from which on nothing rounded is on the surface
};

}  // namespace

PlacedShape compile(const SuperellipsoidNode& node, const ShapeContext&) {
  return {std::make_shared<Superellipsoid>(node.exponents), false, {}};
}

}  // namespace durer
