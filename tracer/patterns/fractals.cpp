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
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

struct Complex {
  double re, im;
  friend Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
  friend Complex operator+(Complex a, double b) { return {a.re + b, a.im}; }
  friend Complex operator-(Complex a, double b) { return {a.re - b, a.im}; }
  friend Complex operator*(double s, Complex a) { return {s * a.re, s * a.im}; }
  friend Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend Complex operator/(Complex a, Complex b) {
    const double d = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / d, (a.im * b.re - a.re * b.im) / d};
  }
  bool operator==(const Complex& other) const { return re == other.re && im == other.im; }
  double squared() const { return re * re + im * im; }
};

Complex power(Complex z, int exponent) {
  Complex result = z;
  for (int i = 1; i < exponent; ++i) result = result * z;
  return result;
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
  double base_value(const Vec3& p, const PatternContext&) const override;

 private:
  static constexpr bool kIsMagnet = kMap != Map::mandel && kMap != Map::julia;
  static constexpr bool kIsJulia =
      kMap == Map::julia || kMap == Map::magnet1_julia || kMap == Map::magnet2_julia;

  Complex step(Complex z, Complex c) const {
    if constexpr (kMap == Map::mandel || kMap == Map::julia) {
      if (f_.exponent == 2)
        return {z.re * z.re - z.im * z.im + c.re, 2 * z.re * z.im + c.im};
      return power(z, f_.exponent) + c;
    } else if constexpr (kMap == Map::magnet1_mandel || kMap == Map::magnet1_julia) {
      const Complex q = (z * z + c - 1) / (2.0 * z + c - 2);
      return q * q;
    } else {
      const Complex product = (c - 1) * (c - 2), square = z * z;
      const Complex q = (square * z + 3.0 * ((c - 1) * z) + product) /
                        (3.0 * square + 3.0 * ((c - 2) * z) + product + 1);
      return q * q;
    }
  }
  bool stops(Complex z) const {
    if constexpr (!kIsMagnet) return z.squared() > 4;
    return z.squared() > 10000 || (z - 1).squared() < 1.0 / 10000;
  }
  double exterior(Complex z, int k) const;
  double interior(Complex z, double least) const;

  FractalParameters f_;
};

template <Map kMap>
double Fractal<kMap>::base_value(const Vec3& p, const PatternContext&) const {
  const Complex point{p.x, p.y};
  const Complex c = kIsJulia ? Complex{f_.coordinates.x, f_.coordinates.y} : point;
  Complex z = kIsMagnet && !kIsJulia ? Complex{0, 0} : point;
  double least = kIsMagnet && !kIsJulia ? 10000 : z.squared();
  // An orbit that comes back to the very same number goes round for ever (Brent 1980, "An improved
  // Monte Carlo factorization algorithm": it is compared with its place at the last power of two).
  // Asked once in so many steps, since most orbits escape.
  constexpr int kLap = 32;
  Complex mark = z;
  int marked = 0;
  for (int k = 0; k < f_.iterations;) {
    const int lap_end = f_.iterations - k > kLap ? k + kLap : f_.iterations;
    for (; k < lap_end; ++k) {
      z = step(z, c);
      least = std::min(least, z.squared());
      if (stops(z)) return exterior(z, k);
    }
    if (kMap == Map::mandel && k == kLap && f_.interior_type == 0 && f_.exponent == 2 &&
        is_held(c, f_.iterations)) {
      break;
    }
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
