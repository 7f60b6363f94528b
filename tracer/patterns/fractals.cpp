// mandel, julia, magnet mandel, magnet julia: iterated maps of the complex plane z = x + iy.
//
//   mandel N, julia <cr,ci>, N          N: iteration limit
//   magnet 1|2 mandel N, magnet 1|2 julia <cr,ci>, N
//   exponent E   2..33 (mandel and julia)             2
//   exterior T, F   0..8, factor                      1, 1
//   interior T, F   0..6, factor                      0, 1
//
//   pigment { mandel 50 exterior 1, 1 interior 1, 1 color_map { [0 rgb 0] [1 rgb <1,.8,.3>] } }
//
// Source: spec/textures.md 7.
#include <emmintrin.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

// Four numbers side by side. Chains of iterations leave a processor idle; four of them do not.
class Four {
 public:
  Four(double all) : low_{all, all}, high_{all, all} {}
  Four(double a, double b, double c, double d) : low_{a, b}, high_{c, d} {}

  double operator[](int lane) const { return lane < 2 ? low_[lane] : high_[lane - 2]; }
  friend Four operator+(const Four& a, const Four& b) {
    return {a.low_ + b.low_, a.high_ + b.high_};
  }
  friend Four operator-(const Four& a, const Four& b) {
    return {a.low_ - b.low_, a.high_ - b.high_};
  }
  friend Four operator*(const Four& a, const Four& b) {
    return {a.low_ * b.low_, a.high_ * b.high_};
  }
  friend Four operator/(const Four& a, const Four& b) {
    return {a.low_ / b.low_, a.high_ / b.high_};
  }
  // Bits of the lanes where a < b.
  friend int operator<(const Four& a, const Four& b) {
    return _mm_movemask_pd(_mm_cmplt_pd(a.low_, b.low_)) |
           _mm_movemask_pd(_mm_cmplt_pd(a.high_, b.high_)) << 2;
  }
  friend Four smaller(const Four& a, const Four& b) {
    return {_mm_min_pd(b.low_, a.low_), _mm_min_pd(b.high_, a.high_)};
  }

 private:
  Four(__m128d low, __m128d high) : low_(low), high_(high) {}

  __m128d low_, high_;
};
double smaller(double a, double b) { return std::min(a, b); }

template <typename Number>
struct ComplexOf {
  Number re, im;
  friend ComplexOf operator+(ComplexOf a, ComplexOf b) { return {a.re + b.re, a.im + b.im}; }
  friend ComplexOf operator+(ComplexOf a, double b) { return {a.re + b, a.im}; }
  friend ComplexOf operator-(ComplexOf a, double b) { return {a.re - b, a.im}; }
  friend ComplexOf operator*(double s, ComplexOf a) { return {s * a.re, s * a.im}; }
  friend ComplexOf operator*(ComplexOf a, ComplexOf b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend ComplexOf operator/(ComplexOf a, ComplexOf b) {
    const Number d = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / d, (a.im * b.re - a.re * b.im) / d};
  }
  bool operator==(const ComplexOf& other) const { return re == other.re && im == other.im; }
  Number squared() const { return re * re + im * im; }
};
using Complex = ComplexOf<double>;

// Of 3 and 4 rounded as POV-Ray rounds them (measured on povray 3.7); the square is step()'s own.
template <typename Number>
ComplexOf<Number> power(const ComplexOf<Number>& z, int exponent) {
  const Number &a = z.re, &b = z.im;
  const Number a2 = a * a, b2 = b * b;
  if (exponent == 3) return {a2 * a - 3 * a * b2, 3 * a2 * b - b2 * b};
  if (exponent == 4)
    return {a2 * a2 - 6 * a2 * b2 + b2 * b2, 4 * a2 * a * b - 4 * a * b2 * b};
  ComplexOf<Number> result = z;
  for (int i = 1; i < exponent; ++i) result = result * z;
  return result;
}

// By the binomial theorem, rounded as POV-Ray rounds it (measured on povray 3.7).
Complex binomial_power(const Complex& z, int exponent) {
  double parts[2] = {0, 0};
  double binomial = 1;
  for (int k = 0; k <= exponent; ++k) {
    const double term = binomial * std::pow(z.re, exponent - k) * std::pow(z.im, k);
    parts[k % 2] += k % 4 < 2 ? term : -term;
    binomial = binomial * (exponent - k) / (k + 1);
  }
  return {parts[0], parts[1]};
}

enum class Map { mandel, julia, magnet1_mandel, magnet1_julia, magnet2_mandel, magnet2_julia };

// Whether rounding cannot lead the orbit of c under z² + c, of so many steps, out of the Mandelbrot set:
// c is in one of its two largest parts, where a fixed point (multiplier 1 - √(1 - 4c)) or a cycle of two
// (4c + 4) attracts, and not close to the edge. By Schwarz's lemma an error of one step grows at most
// as 4/d, d the orbit's distance from the Julia set, which is at least about 1 - |multiplier|: n steps
// of 2e-16 stay below d where d² > 8e-16 n. Asked is a hundred times that.
bool is_held(Complex c, int steps) {
  const double margin = std::sqrt(1e-13 * steps);
  const double most = (1 - margin) * (1 - margin);
  if (margin >= 1) return false;
  const Complex of_two = 4.0 * (c + 1);
  if (of_two.squared() < most) return true;
  const Complex w = -4.0 * c + 1;
  const double root_re = std::sqrt((std::sqrt(w.squared()) + w.re) / 2);
  const Complex of_one{1 - root_re, w.im / (2 * root_re)};
  return of_one.squared() < most;
}

template <Map kMap>
class Fractal : public BasePattern {
 public:
  explicit Fractal(const FractalParameters& f) : f_(f) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    const Complex point{p.x, p.y};
    const Complex z = start(point);
    return follow(point, z, first_least(z), 0);
  }
  void base_values(const Vec3 points[4], const PatternContext&, double out[4]) const override;

 private:
  static constexpr bool kIsMagnet = kMap != Map::mandel && kMap != Map::julia;
  static constexpr bool kIsJulia =
      kMap == Map::julia || kMap == Map::magnet1_julia || kMap == Map::magnet2_julia;

  template <typename Number>
  static ComplexOf<Number> start(const ComplexOf<Number>& point) {
    if constexpr (kIsMagnet && !kIsJulia) return {0, 0};
    return point;
  }
  template <typename Number>
  static Number first_least(const ComplexOf<Number>& z) {
    if constexpr (kIsMagnet && !kIsJulia) return 10000;
    return z.squared();
  }
  template <typename Number>
  ComplexOf<Number> constant(const ComplexOf<Number>& point) const {
    if constexpr (kIsJulia) return {f_.coordinates.x, f_.coordinates.y};
    return point;
  }
  // The value at a point whose orbit has come to z by k steps, where the least square was `least`.
  double follow(Complex point, Complex z, double least, int k) const;

  template <typename Number>
  ComplexOf<Number> step(ComplexOf<Number> z, ComplexOf<Number> c) const {
    if constexpr (kMap == Map::mandel || kMap == Map::julia) {
      if (f_.exponent == 2)
        return {z.re * z.re - z.im * z.im + c.re, 2 * z.re * z.im + c.im};
      return power(z, f_.exponent) + c;
    } else if constexpr (kMap == Map::magnet1_mandel || kMap == Map::magnet1_julia) {
      const auto q = (z * z + c - 1) / (2.0 * z + c - 2);
      return q * q;
    } else {
      // (c - 1)(c - 2), its parts rounded as POV-Ray rounds them.
      const ComplexOf<Number> product{(c.re - 1) * (c.re - 2) - c.im * c.im,
                                      (2 * c.re - 3) * c.im};
      const ComplexOf<Number> three_squares{3 * (z.re * z.re - z.im * z.im), 6 * z.re * z.im};
      const auto q = (power(z, 3) + 3.0 * ((c - 1) * z) + product) /
                     (three_squares + 3.0 * ((c - 2) * z) + product + 1);
      return q * q;
    }
  }
  // Where an orbit escapes to. If it is far, the last digits are all that is seen of it: then higher
  // powers are rounded as in POV-Ray, which would be slow at every step.
  Complex escape(const Complex& before, const Complex& z, const Complex& c) const {
    const bool is_far = z.squared() > 1e4;
    return is_far && f_.exponent > 4 ? binomial_power(before, f_.exponent) + c : z;
  }
  // Of several orbits: a bit for each.
  template <typename Number>
  static int stops(const ComplexOf<Number>& z, const Number& squared) {
    if constexpr (!kIsMagnet) return Number(4) < squared;
    return (Number(10000) < squared) | ((z - 1).squared() < Number(1.0 / 10000));
  }
  double exterior(Complex z, int k) const;
  double interior(Complex z, double least) const;

  FractalParameters f_;
};

// Asked once in so many steps, since most orbits escape: whether the rest is known.
constexpr int kLap = 32;

template <Map kMap>
double Fractal<kMap>::follow(Complex point, Complex z, double least, int k) const {
  const Complex c = constant(point);
  // An orbit that comes back to the very same number goes round for ever (Brent 1980, "An improved
  // Monte Carlo factorization algorithm": it is compared with its place at the last power of two).
  Complex mark = z;
  int marked = k;
  bool is_first_lap = true;
  while (k < f_.iterations) {
    const int lap_end = f_.iterations - k > kLap ? k + kLap : f_.iterations;
    for (; k < lap_end; ++k) {
      const Complex before = z;
      z = step(z, c);
      const double squared = z.squared();
      least = smaller(least, squared);
      if (stops(z, squared)) return exterior(escape(before, z, c), k);
    }
    if (kMap == Map::mandel && is_first_lap && k < f_.iterations && f_.interior_type == 0 &&
        f_.exponent == 2 && is_held(c, f_.iterations)) {
      break;
    }
    is_first_lap = false;
    if (z == mark) {
      for (int left = (f_.iterations - k) % (k - marked); left > 0; --left) z = step(z, c);
      break;
    }
    if (k / 2 >= marked) {
      mark = z;
      marked = k;
    }
  }
  return interior(z, least);
}

template <Map kMap>
void Fractal<kMap>::base_values(const Vec3 points[4], const PatternContext&, double out[4]) const {
  const ComplexOf<Four> point{{points[0].x, points[1].x, points[2].x, points[3].x},
                              {points[0].y, points[1].y, points[2].y, points[3].y}};
  const ComplexOf<Four> c = constant(point);
  ComplexOf<Four> z = start(point);
  Four least = first_least(z);
  const auto lane = [&](const ComplexOf<Four>& of, int i) { return Complex{of.re[i], of.im[i]}; };
  int running = 15;
  int k = 0;
  for (const int end = std::min(f_.iterations, 2 * kLap); k < end; ++k) {
    const ComplexOf<Four> before = z;
    z = step(z, c);
    const Four squared = z.squared();
    least = smaller(least, squared);
    const int stopped = stops(z, squared) & running;
    if (!stopped) continue;
    for (int i = 0; i < 4; ++i) {
      if (stopped >> i & 1)
        out[i] = exterior(escape(lane(before, i), lane(z, i), lane(c, i)), k);
    }
    running &= ~stopped;
    if (!running) return;
  }
  for (int i = 0; i < 4; ++i) {
    if (running >> i & 1) out[i] = follow(lane(point, i), lane(z, i), least[i], k);
  }
}

template <Map kMap>
double Fractal<kMap>::exterior(Complex z, int k) const {
  const double factor = f_.exterior_factor;
  // k modulo a whole number; a number below 1 has no remainder.
  const auto remainder = [&](double modulus) {
    const int m = static_cast<int>(std::clamp(modulus, -2e9, 2e9));
    return m == 0 ? 0.0 : static_cast<double>(k % m) / factor;
  };
  switch (f_.exterior_type) {
    case 0: return factor;
    case 1: return static_cast<double>(k) / f_.iterations;
    case 2: return z.re * factor;
    case 3: return z.im * factor;
    case 4: return z.re * z.re * factor;
    case 5: return z.im * z.im * factor;
    case 6: return std::sqrt(z.squared()) * factor;
    case 7: return remainder(factor);
    case 8: return remainder(1 + factor);
    default: return 0;
  }
}

template <Map kMap>
double Fractal<kMap>::interior(Complex z, double least) const {
  const double factor = f_.interior_factor;
  switch (f_.interior_type) {
    case 0: return factor;
    case 1: return std::sqrt(least) * factor;
    case 2: return z.re * factor;
    case 3: return z.im * factor;
    case 4: return z.re * z.re * factor;
    case 5: return z.im * z.im * factor;
    case 6: return z.re * z.re + z.im * z.im * factor;  // sic
    default: return 0;
  }
}

}  // namespace

std::unique_ptr<const BasePattern> make_mandel(const PatternNode& node, const PatternSettings&) {
  return std::make_unique<Fractal<Map::mandel>>(node.fractal);
}
std::unique_ptr<const BasePattern> make_julia(const PatternNode& node, const PatternSettings&) {
  return std::make_unique<Fractal<Map::julia>>(node.fractal);
}
std::unique_ptr<const BasePattern> make_magnet_mandel(const PatternNode& node,
                                                      const PatternSettings&) {
  if (node.fractal.magnet_type == 1)
    return std::make_unique<Fractal<Map::magnet1_mandel>>(node.fractal);
  return std::make_unique<Fractal<Map::magnet2_mandel>>(node.fractal);
}
std::unique_ptr<const BasePattern> make_magnet_julia(const PatternNode& node,
                                                     const PatternSettings&) {
  if (node.fractal.magnet_type == 1)
    return std::make_unique<Fractal<Map::magnet1_julia>>(node.fractal);
  return std::make_unique<Fractal<Map::magnet2_julia>>(node.fractal);
}

}  // namespace durer
