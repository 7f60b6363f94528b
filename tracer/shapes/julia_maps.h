// The maps z -> f(z) + c that julia_fractal iterates, with the derivative vectors that its distance
// estimates and normals are made of (spec/geometry.md 12.15).
#pragma once

#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <type_traits>

#include "tracer/scene/shapes.h"

namespace durer {

// i·j = k with i² = j² = k² = -1; x is the real part. Sums in the order of POV-Ray's last digits, which
// orbits blow up (decision 0071).
inline Vec4 quaternion_product(const Vec4& a, const Vec4& b) {
  return {a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w,
          a.x * b.y + a.y * b.x + a.z * b.w - a.w * b.z,
          a.x * b.z + a.z * b.x + a.w * b.y - a.y * b.w,
          a.x * b.w + a.w * b.x + a.y * b.z - a.z * b.y};
}

inline double dot_in_order(const Vec4& a, const Vec4& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

// What maps and sizes are made of: of one number, or of several side by side.
template <typename Number>
struct QuaternionSquares {
  Number real, rest;

  template <typename Numbers>
  [[gnu::always_inline]] explicit QuaternionSquares(const Numbers& z)
      : real(z.x * z.x), rest(z.y * z.y + z.z * z.z + z.w * z.w) {}
  // Summed as povray does.
  [[gnu::always_inline]] Number sum() const { return real + rest; }
};
template <typename Numbers>
QuaternionSquares(const Numbers& z) -> QuaternionSquares<std::decay_t<decltype(z.x * z.x)>>;

constexpr double kLeastJuliaStep = 1e-7;  // of the search for the border

// A point of the walk along a ray, as it was come to.
struct JuliaPlace {
  Vec3 point;
  double t;
};

// The slice of the fourfold space that is seen, and how far its points are followed.
struct JuliaSlice {
  Vec4 normal;
  double distance;
  int iterations;
  double escape2;  // squares beyond have left

  // The point in fourfold space.
  Vec4 start(const Vec3& p) const {
    return {p.x, p.y, p.z,
            (distance - normal.x * p.x - normal.y * p.y - normal.z * p.z) / normal.w};
  }
};

struct QuaternionSquare {
  using Number = Vec4;
  static constexpr bool kQuaternion = true, kMixesUpStart = false;
  static constexpr double kDegree = 2;
  Vec4 c;

  Vec4 operator()(const Vec4& z) const { return image(z, QuaternionSquares(z)); }
  template <typename Numbers, typename Squares>
  [[gnu::always_inline]] Numbers image(const Numbers& z, const Squares& squares) const {
    return {squares.real - squares.rest + c.x, 2.0 * z.x * z.y + c.y, 2.0 * z.x * z.z + c.z,
            2.0 * z.x * z.w + c.w};
  }
  static double squared_size(const Vec4& z) { return QuaternionSquares(z).sum(); }
  // How far the images of two numbers are apart at most, one of that size and one `apart` from it.
  template <typename Number>
  [[gnu::always_inline]] static Number spread(const Number& size, const Number& apart) {
    return apart * (2 * size + apart);
  }
  // The image of a tangent v at z, up to a factor.
  static Vec4 carry(const Vec4& z, const Vec4& v) {
    return {z.x * v.x - z.y * v.y - z.z * v.z - z.w * v.w, v.x * z.y + z.x * v.y,
            v.x * z.z + z.x * v.z, v.x * z.w + z.x * v.w};
  }
};

struct QuaternionCube {
  using Number = Vec4;
  static constexpr bool kQuaternion = true, kMixesUpStart = false;
  static constexpr double kDegree = 3;
  Vec4 c;

  Vec4 operator()(const Vec4& z) const { return image(z, QuaternionSquares(z)); }
  template <typename Numbers, typename Squares>
  [[gnu::always_inline]] Numbers image(const Numbers& z, const Squares& squares) const {
    const auto factor = 3.0 * squares.real - squares.rest;
    return {z.x * (squares.real - 3.0 * squares.rest) + c.x, z.y * factor + c.y,
            z.z * factor + c.z, z.w * factor + c.w};
  }
  static double squared_size(const Vec4& z) { return QuaternionSquares(z).sum(); }
  template <typename Number>
  [[gnu::always_inline]] static Number spread(const Number& size, const Number& apart) {
    return apart * (3 * size * (size + apart) + apart * apart);
  }
  static Vec4 carry(const Vec4& z, const Vec4& v) {
    const double t = 2 * (z.y * v.y + z.z * v.z + z.w * v.w);
    const double d = z.y * z.y + z.z * z.z + z.w * z.w;
    const double a = z.x * z.x - d, b = 3 * z.x * z.x - d, along = 6 * z.x * v.x - t;
    return {3 * (a * v.x - z.x * t), b * v.y + z.y * along, b * v.z + z.z * along,
            b * v.w + z.w * along};
  }
};

// i² = j² = -1, k² = 1, i·j = k: commutative.
inline Vec4 hypercomplex_product(const Vec4& a, const Vec4& b) {
  return {
      a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
      a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
}

// Hypercomplex numbers as their maps compute with them: as they are, or on two complex planes.
inline double squared_size(const Vec4& z) {
  return glm::dot(z, z);
}
inline Vec4 product(const Vec4& a, const Vec4& b) {
  return hypercomplex_product(a, b);
}
inline Vec4 as_vector(const Vec4& z) {
  return z;
}

// The two complex planes that the algebra splits into, side by side: there the product is that of
// complex numbers.
struct OnPlanes {
  using Lanes = double __attribute__((vector_size(16)));

  Lanes re, im;

  explicit OnPlanes(const Vec4& z) : re{z.x - z.w, z.x + z.w}, im{z.y + z.z, z.y - z.z} {}
  OnPlanes(const Lanes& real, const Lanes& imaginary) : re(real), im(imaginary) {}
};
inline double squared_size(const OnPlanes& z) {
  const OnPlanes::Lanes squares = z.re * z.re + z.im * z.im;
  return 0.5 * (squares[0] + squares[1]);
}
inline OnPlanes product(const OnPlanes& a, const OnPlanes& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Vec4 as_vector(const OnPlanes& z) {
  return 0.5 * Vec4(z.re[0] + z.re[1], z.im[0] + z.im[1], z.im[0] - z.im[1], z.re[1] - z.re[0]);
}

struct HypercomplexSquare {
  using Number = Vec4;
  static constexpr bool kQuaternion = false, kMixesUpStart = false;
  Vec4 c;

  static double squared_size(const Vec4& z) { return durer::squared_size(z); }

  Vec4 operator()(const Vec4& z) const {
    return Vec4(z.x * z.x - z.y * z.y - z.z * z.z + z.w * z.w, 2 * (z.x * z.y - z.z * z.w),
                2 * (z.x * z.z - z.y * z.w), 2 * (z.x * z.w + z.y * z.z)) +
           c;
  }
  // Takes the step k; returns the factor by which that changes the derivative. scale(): of m steps.
  Vec4 factor_of_step(Vec4& z, int) const {
    const Vec4 before = z;
    z = (*this)(z);
    return before;
  }
  // 2^m, but for m = 0.
  static double scale(int m) {
    if (m == 0) return 2;
    return m < 1024 ? std::bit_cast<double>(static_cast<uint64_t>(1023 + m) << 52) : HUGE_VAL;
  }
};

// POV-Ray iterates the square for `cube`, too, but with another estimate of the distance.
struct HypercomplexCube : HypercomplexSquare {
  static double scale(int) { return 1; }
};

// A complex function on the two planes that the algebra splits into.
template <typename Function>
Vec4 on_both_planes(const Vec4& z, const Function& function) {
  const std::complex<double> a = function(std::complex<double>(z.x - z.w, z.y + z.z));
  const std::complex<double> b = function(std::complex<double>(z.x + z.w, z.y - z.z));
  return 0.5 *
         Vec4(a.real() + b.real(), a.imag() + b.imag(), a.imag() - b.imag(), b.real() - a.real());
}

struct HypercomplexReciprocal {
  using Number = OnPlanes;
  static constexpr bool kQuaternion = false, kMixesUpStart = false;

  explicit HypercomplexReciprocal(const Vec4& constant) : c(constant) {}

  static double squared_size(const OnPlanes& z) { return durer::squared_size(z); }
  OnPlanes operator()(const OnPlanes& z) const { return plus_c(reciprocal(z)); }
  OnPlanes factor_of_step(OnPlanes& z, int k) const {
    const OnPlanes r = reciprocal(z), square = product(r, r);
    const OnPlanes factor = k == 0 ? z : OnPlanes(-square.re, -square.im);
    z = plus_c(r);
    return factor;
  }
  static double scale(int) { return 1; }

 private:
  static OnPlanes reciprocal(const OnPlanes& z) {
    const OnPlanes::Lanes squares = z.re * z.re + z.im * z.im;
    return {z.re / squares, -z.im / squares};
  }
  OnPlanes plus_c(const OnPlanes& z) const { return {z.re + c.re, z.im + c.im}; }

  OnPlanes c;
};

using ComplexFunction = std::complex<double> (*)(const std::complex<double>& z, const Vec2& power);
ComplexFunction complex_function(JuliaFractalNode::Function function);

struct HypercomplexFunction {
  using Number = Vec4;
  // The plain iteration starts with y in the place of z, as in POV-Ray.
  static constexpr bool kQuaternion = false, kMixesUpStart = true;
  Vec4 c;
  ComplexFunction function;
  Vec2 power;

  static double squared_size(const Vec4& z) { return durer::squared_size(z); }
  Vec4 image(const Vec4& z) const {
    return on_both_planes(z, [&](const std::complex<double>& w) { return function(w, power); });
  }
  Vec4 operator()(const Vec4& z) const { return image(z) + c; }
  Vec4 factor(const Vec4& z, int k) const { return k == 0 ? z : image(z); }
  Vec4 factor_of_step(Vec4& z, int k) const {
    const Vec4 f = image(z), factor = k == 0 ? z : f;
    z = f + c;
    return factor;
  }
  static double scale(int) { return 1; }
};

}  // namespace durer
