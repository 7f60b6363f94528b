// cubic, quartic, poly, polynomial: f(x,y,z) = 0                       (spec/geometry.md 14.3)
#include <algorithm>
#include <array>
#include <cmath>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kLeastCoefficient = 1e-20;
constexpr double kInsideTolerance = 1e-4;
constexpr double kRootElimination = 1e-4;

struct Term {
  double coefficient;
  int x, y, z;  // powers
};

class Poly final : public Shape {
 public:
  explicit Poly(const PolyNode& node)
      : coefficients_(node.coefficients), order_(node.order), sturm_(node.sturm) {
    size_t next = 0;
    coefficients_.resize(static_cast<size_t>((order_ + 1) * (order_ + 2) * (order_ + 3) / 6));
    for (int i = order_; i >= 0; --i) {
      for (int j = order_ - i; j >= 0; --j) {
        row_has_terms_.push_back(false);
        for (int k = order_ - i - j; k >= 0; --k) {
          const double c = coefficients_[next++];
          if (c == 0) continue;
          terms_.push_back({c, i, j, k});
          row_has_terms_.back() = true;
        }
      }
    }
  }

  Bounds bounds() const override { return Bounds::everything(); }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double scale = 1 / length(ray.direction);
    const Vec3 d = ray.direction * scale;
    double c[kMostPolynomialDegree + 1];
    switch (order_) {
      case 3: substitute<3>(ray.origin, d, c); break;
      case 4: substitute<4>(ray.origin, d, c); break;
      default: substitute<kAnyOrder>(ray.origin, d, c);
    }
    double roots[kMostPolynomialDegree];
    int count = 0;
    if (order_ == 2) {
      count = solve_second_order(c, roots);
    } else {
      int degree = order_;
      const double* first = c;
      while (degree > 0 && *first == 0) {
        ++first;
        --degree;
      }
      if (degree <= 1) return;
      count = solve_polynomial(degree, first, sturm_, kRootElimination, roots);
    }
    for (int i = 0; i < count; ++i) {
      if (roots[i] <= 1e-4 || std::find(roots, roots + i, roots[i]) != roots + i) continue;
      out.push(roots[i] * scale);
    }
  }

  bool inside(const Vec3& p) const override { return value(p) < kInsideTolerance; }

  Vec3 normal(const Vec3& p, const ShapeHit&) const override {
    Powers powers(p, order_);
    Vec3 n(0);
    for (const Term& t : terms_) {
      const double x = powers.of[0][t.x], y = powers.of[1][t.y], z = powers.of[2][t.z];
      if (t.x) n.x += t.coefficient * t.x * powers.of[0][t.x - 1] * y * z;
      if (t.y) n.y += t.coefficient * t.y * x * powers.of[1][t.y - 1] * z;
      if (t.z) n.z += t.coefficient * t.z * x * y * powers.of[2][t.z - 1];
    }
    return n == Vec3(0) ? Vec3(1, 0, 0) : n;
  }

 private:
  using Row = std::array<double, kMostPolynomialDegree + 1>;
  struct Powers {
    Powers(const Vec3& p, int order) {
      for (int axis = 0; axis < 3; ++axis) {
        of[axis][0] = 1;
        for (size_t i = 1; i <= static_cast<size_t>(order); ++i) of[axis][i] = of[axis][i - 1] * p[axis];
      }
    }
    Row of[3];
  };

  double value(const Vec3& p) const {
    const Powers powers(p, order_);
    double sum = 0;
    for (const Term& t : terms_)
      sum += t.coefficient * powers.of[0][t.x] * powers.of[1][t.y] * powers.of[2][t.z];
    return sum;
  }

  // c[0] t^order + …: each term is (Px + t dx)^i (Py + t dy)^j (Pz + t dz)^k. With x^i outside,
  // y^j within and z^k innermost, Horner's rule needs one multiplication by a line per power. Of an
  // order that the compiler knows all loops are unrolled.
  static constexpr int kAnyOrder = 0;
  template <int kOrder>
  void substitute(const Vec3& p, const Vec3& d, double* c) const {
    constexpr int kSize = (kOrder == kAnyOrder ? kMostPolynomialDegree : kOrder) + 1;
    const int order = kOrder == kAnyOrder ? order_ : kOrder;
    const double* next = coefficients_.data();
    size_t row = 0;
    // q has ascending powers up to degree.
    const auto times_line = [](double* q, int degree, double constant, double slope) {
      q[degree + 1] = q[degree] * slope;
#pragma GCC unroll 8
      for (int i = degree; i > 0; --i) q[i] = q[i] * constant + q[i - 1] * slope;
      q[0] *= constant;
    };
    double all[kSize] = {};
#pragma GCC unroll 8
    for (int i = order; i >= 0; --i) {
      if (i < order) times_line(all, order - i - 1, p.x, d.x);
      double inner[kSize] = {};
#pragma GCC unroll 8
      for (int j = order - i; j >= 0; --j) {
        const int most = order - i - j;
        if (most > 0) times_line(inner, most - 1, p.y, d.y);
        if (!row_has_terms_[row++]) {
          next += most + 1;
          continue;
        }
        double innermost[kSize] = {};
#pragma GCC unroll 8
        for (int k = most; k >= 0; --k) {
          if (k < most) times_line(innermost, most - k - 1, p.z, d.z);
          innermost[0] += *next++;
        }
#pragma GCC unroll 8
        for (int m = 0; m <= most; ++m) inner[m] += innermost[m];
      }
#pragma GCC unroll 8
      for (int m = 0; m <= order - i; ++m) all[m] += inner[m];
    }
    for (int i = 0; i <= order; ++i) c[order - i] = all[i];
  }

  static int solve_second_order(const double* c, double* roots) {
    if (std::abs(c[0]) < kLeastCoefficient) {
      if (std::abs(c[1]) < kLeastCoefficient) return 0;
      roots[0] = -c[2] / c[1];
      return 1;
    }
    const double discriminant = c[1] * c[1] - 4 * c[0] * c[2];
    if (discriminant < 0) return 0;
    const double root = std::sqrt(discriminant);
    roots[0] = (-c[1] + root) / (2 * c[0]);
    roots[1] = (-c[1] - root) / (2 * c[0]);
    return 2;
  }

  std::vector<double> coefficients_;  // all, in the order of the statement
  std::vector<Term> terms_;           // those that are not 0
  std::vector<char> row_has_terms_;   // for each power of x and of y
  int order_;
  bool sturm_;
};

}  // namespace

PlacedShape compile(const PolyNode& node, const ShapeContext&) {
  return {std::make_shared<Poly>(node), false, {}};
}

}  // namespace durer
