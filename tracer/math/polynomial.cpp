#include "tracer/math/polynomial.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tracer/math/min_max.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;
constexpr double kRelativeError = 1e-12;
constexpr int kMostHalvings = 50;

// Coefficients differ by more than a double carries: Sturm's method is asked (degree 4).
bool is_difficult(const double* c) {
  double largest = 0;
  for (int i = 0; i <= 4; ++i) {
    if (std::abs(c[i]) > largest) largest = c[i];  // signed, as the reference does
  }
  if (largest == 0) return false;
  for (int i = 0; i <= 4; ++i) {
    if (c[i] != 0 && std::abs(largest / c[i]) > 1e12) return true;
  }
  return false;
}

// --- Sturm's method ---

struct SturmTerm {
  int degree;
  double c[kMostPolynomialDegree + 1];  // ascending powers

  double value(double x) const {
    if (degree == 4) return (((c[4] * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0];
    double sum = c[degree];
    for (int i = degree - 1; i >= 0; --i) sum = sum * x + c[i];
    return sum;
  }
};

struct SturmSequence {
  SturmTerm term[kMostPolynomialDegree + 1];
  int last;
  // From here on all terms have the sign of their leading coefficients, beyond all rounding: twice
  // Cauchy's bound of their roots.
  double all_roots_below;

  template <typename Value>
  int sign_changes(Value&& value) const {
    int changes = 0;
    double previous = value(term[0]);
    for (int i = 1; i <= last; ++i) {
      const double f = value(term[i]);
      if (previous == 0 || previous * f < 0) ++changes;
      previous = f;
    }
    return changes;
  }
  int changes_at(double x) const {
    return sign_changes([x](const SturmTerm& t) { return t.value(x); });
  }
};

// r = -(u mod v), scaled to a leading coefficient of ±1. v's is ±1.
void find_negated_remainder(const SturmTerm& u, const SturmTerm& v, SturmTerm& r) {
  std::copy_n(u.c, u.degree + 1, r.c);
  const double sign = v.c[v.degree] < 0 ? -1 : 1;
  for (int k = u.degree - v.degree; k >= 0; --k) {
    const double factor = r.c[v.degree + k] * sign;
    for (int j = v.degree + k - 1; j >= k; --j) r.c[j] -= factor * v.c[j - k];
  }
  int degree = v.degree - 1;
  while (degree >= 0 && std::abs(r.c[degree]) < kEpsilon) r.c[degree--] = 0;
  r.degree = degree < 0 ? 0 : degree;
  if (degree < 0) {
    r.c[0] = 0;
    return;
  }
  const double scale = -1 / std::abs(r.c[degree]);
  for (int j = 0; j <= degree; ++j) r.c[j] *= scale;
}

// The same, and all that follow, while each is of one degree less than the one before: of degrees that
// the compiler knows. The last term is of degree kDegree - 1.
template <int kDegree>
void append_regular_terms(SturmSequence& s) {
  if constexpr (kDegree > 1) {
    const double *u = s.term[s.last - 1].c, *v = s.term[s.last].c;
    double r[kDegree];
    const double sign = v[kDegree - 1] < 0 ? -1 : 1;
    const double first = u[kDegree] * sign;
    r[0] = u[0];
    for (int i = 1; i < kDegree; ++i) r[i] = u[i] - first * v[i - 1];
    const double second = r[kDegree - 1] * sign;
    for (int i = 0; i < kDegree - 1; ++i) r[i] -= second * v[i];
    if (!(std::abs(r[kDegree - 2]) >= kEpsilon)) return;
    const double scale = -1 / std::abs(r[kDegree - 2]);
    SturmTerm& next = s.term[++s.last];
    next.degree = kDegree - 2;
    for (int i = 0; i < kDegree - 1; ++i) next.c[i] = r[i] * scale;
    append_regular_terms<kDegree - 1>(s);
  }
}

void build(SturmSequence& s, int degree, const double* c) {
  s.term[0].degree = degree;
  for (int i = 0; i <= degree; ++i) s.term[0].c[i] = c[degree - i] / c[0];
  s.term[1].degree = degree - 1;
  const double scale = 1 / std::abs(s.term[0].c[degree] * degree);
  for (int i = 1; i <= degree; ++i) s.term[1].c[i - 1] = s.term[0].c[i] * i * scale;
  s.last = 1;
  switch (degree) {
    case 3: append_regular_terms<3>(s); break;
    case 4: append_regular_terms<4>(s); break;
    case 5: append_regular_terms<5>(s); break;
    case 6: append_regular_terms<6>(s); break;
    default: break;
  }
  while (s.term[s.last].degree > 0) {
    find_negated_remainder(s.term[s.last - 1], s.term[s.last], s.term[s.last + 1]);
    const SturmTerm& next = s.term[s.last + 1];
    if (next.degree == 0 && next.c[0] == 0) break;  // multiple root
    ++s.last;
  }
  double largest = 0;
  for (int i = 0; i <= s.last; ++i) {
    const SturmTerm& t = s.term[i];
    for (int j = 0; j < t.degree; ++j) largest = larger_of(std::abs(t.c[j]), largest);
  }
  s.all_roots_below = 2 * (1 + largest);
}

// Whether an error is small at x. Nearly all are not, which is told without the quotient.
bool is_small(double error, double x) {
  if (std::abs(x) <= kRelativeError) return std::abs(error) < kRelativeError;
  return std::abs(error) <= 2 * kRelativeError * std::abs(x) &&
         std::abs(error / x) < kRelativeError;
}

// Whether regula falsi cannot leave the neighbourhood of 0: each step halves f(b) at most and is at
// most |f(0)| b / |f(b)| times 3/2 long while f is about f(0); the sum of all steps, 3/2 2^50 times that,
// changes f by no more than |f(0)| / 2. So it is where b is as far as most searches start.
bool is_stuck_at_zero(const SturmTerm& f, double b, double fb) {
  double sum = 0;
  for (int i = 0; i <= f.degree; ++i) sum += std::abs(f.c[i]);
  constexpr double kMostGrowth = 4.0 * (int64_t{1} << kMostHalvings);
  return std::abs(f.c[0]) > kEpsilon && std::abs(fb) > kMostGrowth * b * sum;
}

// The one root of s in (a, b], by the Illinois form of regula falsi; false: no convergence.
bool regula_falsi(const SturmTerm& f, double a, double b, double& root) {
  double fa = f.value(a), fb = f.value(b);
  if (fa * fb > 0) return false;
  if (a == 0 && is_stuck_at_zero(f, b, fb)) return false;
  if (std::abs(fa) < kEpsilon) {
    root = a;
    return true;
  }
  if (std::abs(fb) < kEpsilon) {
    root = b;
    return true;
  }
  double previous = fa;
  for (int i = 0; i < kMostHalvings; ++i) {
    const double x = (fb * a - fa * b) / (fb - fa);
    const double fx = f.value(x);
    if (is_small(fx, x)) {
      root = x;
      return true;
    }
    if (fa < 0 ? fx < 0 : fx >= 0) {
      a = x;
      fa = fx;
      if (previous * fx > 0) fb /= 2;
    } else {
      b = x;
      fb = fx;
      if (previous * fx > 0) fa /= 2;
    }
    if (std::abs(b - a) < kRelativeError) {
      root = x;
      return true;
    }
    previous = fx;
  }
  return false;
}

// Halves [0, high] while all roots are in the lower half without a doubt; returns how often.
int halve_to_bound(const SturmSequence& s, double low, double& high) {
  int halvings = 0;
  if (low != 0) return halvings;
  for (; halvings < kMostHalvings && high / 2 > s.all_roots_below; ++halvings) high /= 2;
  return halvings;
}

// The one root of the sequence in (low, high] by bisection; after too many steps, the last point
// tried, not the middle of what is left (measured on povray 3.7). Sign changes tell on which side it
// is; so does the sign of the polynomial itself, where it has one at either end.
double bisect(const SturmSequence& s, double low, double high, int low_changes) {
  const SturmTerm& f = s.term[0];
  const double at_low = f.value(low);
  const bool crosses = at_low * f.value(high) < 0;
  int i = halve_to_bound(s, low, high);
  double middle = high;
  for (; i < kMostHalvings; ++i) {
    middle = (low + high) / 2;
    if (is_small(high - low, middle)) return middle;
    const bool is_above =
        crosses ? f.value(middle) * at_low > 0 : low_changes == s.changes_at(middle);
    low = is_above ? middle : low;
    high = is_above ? high : middle;
  }
  return middle;
}

// Writes the roots in (low, high], ascending; changes are the sign changes at both ends.
int isolate(const SturmSequence& s, double low, double high, int low_changes, int high_changes,
            double* roots) {
  const int count = low_changes - high_changes;
  if (count <= 0) return 0;
  if (count == 1) {
    if (!regula_falsi(s.term[0], low, high, roots[0])) roots[0] = bisect(s, low, high, low_changes);
    return 1;
  }
  // Several: halve until they part.
  int i = halve_to_bound(s, low, high);
  double middle = high;
  for (; i < kMostHalvings; ++i) {
    middle = (low + high) / 2;
    if (is_small(high - low, middle)) break;
    const int changes = s.changes_at(middle);
    const int lower = low_changes - changes, upper = changes - high_changes;
    if (lower > 0 && upper > 0) {
      const int found = isolate(s, low, middle, low_changes, changes, roots);
      return found + isolate(s, middle, high, changes, high_changes, roots + found);
    }
    if (lower == 0) {
      low = middle;
    } else {
      high = middle;
    }
  }
  roots[0] = middle;
  return 1;
}

}  // namespace

int solve_quadratic(const double* coefficient, double* roots) {
  const double a = coefficient[0];
  double b = -coefficient[1], c = coefficient[2];
  if (a == 0) {
    if (b == 0) return 0;
    roots[0] = c / b;
    return 1;
  }
  b /= a;
  c /= a;
  const double d = b * b - 4 * c;
  if (std::abs(d) < kEpsilon) {
    roots[0] = 0.5 * b;
    return 1;
  }
  if (!(d >= 0)) return 0;
  const double root = std::sqrt(d);
  roots[0] = 0.5 * (b + root);
  roots[1] = 0.5 * (b - root);
  return 2;
}

namespace {

// Rounded once: 2 * M_PI / 3 is the double below.
constexpr double kThirdTurn = 2.0943951023931954923, kTwoThirdsTurn = 4.1887902047863909846;

// `only_first`: the others, which may be dear, are not looked for.
int solve_cubic(const double* c, double* roots, bool only_first) {
  if (c[0] == 0) return solve_quadratic(c + 1, roots);
  double a1 = c[1], a2 = c[2], a3 = c[3];
  if (c[0] != 1) {
    a1 /= c[0];
    a2 /= c[0];
    a3 /= c[0];
  }
  const double square = a1 * a1;
  const double q = (square - 3 * a2) / 9;
  const double r = (a1 * (square - 4.5 * a2) + 13.5 * a3) / 27;
  const double q3 = q * q * q;
  const double r2 = r * r;
  const double d = q3 - r2;
  const double shift = a1 / 3;
  if (d >= 0) {
    const double turn = std::sqrt(q3);
    const double theta = std::acos(r / turn) / 3;
    const double size = -2 * std::sqrt(q);
    roots[0] = size * std::cos(theta) - shift;
    if (only_first) return 1;
    roots[1] = size * std::cos(theta + kThirdTurn) - shift;
    roots[2] = size * std::cos(theta + kTwoThirdsTurn) - shift;
    return 3;
  }
  const double s = std::pow(std::sqrt(r2 - q3) + std::abs(r), 1.0 / 3.0);
  roots[0] = r < 0 ? (s + q / s) - shift : -(s + q / s) - shift;
  return 1;
}

}  // namespace

int solve_cubic(const double* c, double* roots) { return solve_cubic(c, roots, false); }

int solve_quartic(const double* c, double* roots) {
  double c1 = c[1], c2 = c[2], c3 = c[3], c4 = c[4];
  if (c[0] != 1) {
    c1 /= c[0];
    c2 /= c[0];
    c3 /= c[0];
    c4 /= c[0];
  }
  // Resolvent cubic.
  const double c12 = c1 * c1;
  const double p = -0.375 * c12 + c2;
  const double q = 0.125 * c12 * c1 - 0.5 * c1 * c2 + c3;
  const double r = -0.01171875 * c12 * c12 + 0.0625 * c12 * c2 - 0.25 * c1 * c3 + c4;
  const double cubic[4] = {1, -0.5 * p, -r, 0.5 * r * p - 0.125 * q * q};
  double z_roots[3];
  if (solve_cubic(cubic, z_roots, true) == 0) return 0;
  const double z = z_roots[0];
  // Two quadratics.
  double d1 = 2 * z - p, d2;
  if (d1 < 0) {
    if (d1 <= -kEpsilon) return 0;
    d1 = 0;
  }
  if (d1 < kEpsilon) {
    d2 = z * z - r;
    if (d2 < 0) return 0;
    d2 = std::sqrt(d2);
  } else {
    d1 = std::sqrt(d1);
    d2 = 0.5 * q / d1;
  }
  const double q1 = d1 * d1;
  const double shift = -0.25 * c1;
  int count = 0;
  double discriminant = q1 - 4 * (z - d2);
  if (discriminant == 0) {
    roots[count++] = -0.5 * d1 - shift;  // the reference's sign
  } else if (discriminant > 0) {
    const double root = std::sqrt(discriminant);
    roots[count++] = -0.5 * (d1 + root) + shift;
    roots[count++] = -0.5 * (d1 - root) + shift;
  }
  discriminant = q1 - 4 * (z + d2);
  if (discriminant == 0) {
    roots[count++] = 0.5 * d1 - shift;
  } else if (discriminant > 0) {
    const double root = std::sqrt(discriminant);
    roots[count++] = 0.5 * (d1 + root) + shift;
    roots[count++] = 0.5 * (d1 - root) + shift;
  }
  return count;
}

int solve_sturm(int degree, const double* c, double* roots, double farthest) {
  if (degree < 1) return 0;
  if (degree == 1) {
    const double root = -c[1] / c[0];
    if (!(root > 0 && root <= farthest)) return 0;
    roots[0] = root;
    return 1;
  }
  SturmSequence sequence;
  build(sequence, degree, c);
  const int at_zero = sequence.sign_changes([](const SturmTerm& t) { return t.c[0]; });
  const int at_infinity = sequence.sign_changes([](const SturmTerm& t) { return t.c[t.degree]; });
  if (at_zero == at_infinity) return 0;
  const int up_to_farthest =
      farthest > sequence.all_roots_below ? at_infinity : sequence.changes_at(farthest);
  return isolate(sequence, 0, farthest, at_zero, up_to_farthest, roots);
}

int solve_polynomial(int degree, const double* c, bool sturm, double epsilon, double* roots,
                     double farthest) {
  while (degree > 0 && std::abs(c[0]) < kEpsilon) {
    ++c;
    --degree;
  }
  switch (degree) {
    case 0: return 0;
    case 1:
      if (c[0] == 0) return 0;
      roots[0] = -c[1] / c[0];
      return 1;
    case 2: return solve_quadratic(c, roots);
    case 3:
      if (epsilon > 0 && c[2] != 0 && std::abs(c[3] / c[2]) < epsilon) {
        return solve_quadratic(c, roots);
      }
      return sturm ? solve_sturm(3, c, roots, farthest) : solve_cubic(c, roots);
    case 4:
      if (epsilon > 0 && c[3] != 0 && std::abs(c[4] / c[3]) < epsilon) {
        return sturm ? solve_sturm(3, c, roots, farthest) : solve_cubic(c, roots);
      }
      return sturm || is_difficult(c) ? solve_sturm(4, c, roots, farthest) : solve_quartic(c, roots);
    default: return solve_sturm(degree, c, roots, farthest);
  }
}

}  // namespace durer
