#include "tracer/shapes/julia_maps.h"

namespace durer {
namespace {

using Complex = std::complex<double>;
constexpr double kLeastExponent = -690;

// Whether the square of a number's size is a number, too; orbits do not get elsewhere for long.
bool is_usual(double size2) { return size2 > 1e-280 && size2 < 1e280; }

Complex square_root(const Complex& z) {
  const double size2 = std::norm(z);
  if (!is_usual(size2)) {
    return std::polar(std::sqrt(std::abs(z)), std::atan2(z.imag(), z.real()) / 2);
  }
  const double larger = std::sqrt(0.5 * (std::sqrt(size2) + std::abs(z.real())));
  const double smaller = 0.5 * std::abs(z.imag()) / larger;
  const bool is_right = z.real() >= 0;
  return {is_right ? larger : smaller, std::copysign(is_right ? smaller : larger, z.imag())};
}
Complex logarithm(const Complex& z) {
  const double size2 = std::norm(z);
  return {is_usual(size2) ? 0.5 * std::log(size2) : std::log(std::abs(z)),
          std::atan2(z.imag(), z.real())};
}
Complex exponential(const Complex& z) {
  return z.real() < kLeastExponent ? Complex(0) : std::polar(std::exp(z.real()), z.imag());
}
Complex times_i(const Complex& z) {
  return {-z.imag(), z.real()};
}

// Both from one exponential; what is lost where sinh is small is lost in every sum with the orbit's
// parameter.
struct Hyperbolic {
  explicit Hyperbolic(double x) {
    const double grown = std::exp(std::abs(x)), shrunk = 1 / grown;
    cosh = 0.5 * (grown + shrunk);
    sinh = std::copysign(0.5 * (grown - shrunk), x);
  }
  double sinh, cosh;
};

// The library's functions of complex numbers look for infinities first, which no orbit reaches.
Complex sine(const Complex& z) {
  const Hyperbolic y(z.imag());
  return {std::sin(z.real()) * y.cosh, std::cos(z.real()) * y.sinh};
}
Complex cosine(const Complex& z) {
  const Hyperbolic y(z.imag());
  return {std::cos(z.real()) * y.cosh, -(std::sin(z.real()) * y.sinh)};
}
Complex hyperbolic_sine(const Complex& z) {
  const Hyperbolic x(z.real());
  return {std::cos(z.imag()) * x.sinh, std::sin(z.imag()) * x.cosh};
}
Complex hyperbolic_cosine(const Complex& z) {
  const Hyperbolic x(z.real());
  return {std::cos(z.imag()) * x.cosh, std::sin(z.imag()) * x.sinh};
}
Complex tangent(const Complex& z) {
  const double x = 2 * z.real();
  const Hyperbolic y(2 * z.imag());
  return Complex(std::sin(x), y.sinh) / (std::cos(x) + y.cosh);
}
Complex hyperbolic_tangent(const Complex& z) {
  const Hyperbolic x(2 * z.real());
  const double y = 2 * z.imag();
  return Complex(x.sinh, std::sin(y)) / (x.cosh + std::cos(y));
}
// By the schoolbook: the imaginary part of a quotient of real numbers is +0, on that side of the
// logarithm's cut.
Complex quotient(const Complex& a, const Complex& b) {
  const Complex product = a * std::conj(b);
  const double size2 = std::norm(b);
  return {product.real() / size2, product.imag() / size2};
}
Complex arc_sine(const Complex& z) {
  return -times_i(logarithm(times_i(z) + square_root(1.0 - z * z)));
}
Complex arc_cosine(const Complex& z) {
  const Complex t = logarithm(z + square_root(z * z - 1.0));
  return {t.imag(), -t.real()};
}
Complex arc_tangent(const Complex& z) {
  if (z.imag() == 0) return {std::atan(z.real()), 0};
  if (z.real() == 0 && std::abs(z.imag()) < 1) return {0, std::atanh(z.imag())};
  return 0.5 * times_i(logarithm(quotient(1.0 - times_i(z), 1.0 + times_i(z))));
}
Complex hyperbolic_arc_tangent(const Complex& z) {
  if (z.real() == 0) return {0, std::atan(z.imag())};
  if (z.imag() == 0 && std::abs(z.real()) == 1) return z;
  return 0.5 * logarithm(quotient(1.0 + z, 1.0 - z));
}
Complex power_of(const Complex& z, const Vec2& power) {
  if (z == Complex(0)) return 0;
  return exponential(Complex(power.x, power.y) * logarithm(z));
}

}  // namespace

ComplexFunction complex_function(JuliaFractalNode::Function function) {
  using F = JuliaFractalNode::Function;
  switch (function) {
    case F::exp:
      return [](const Complex& z, const Vec2&) { return exponential(z); };
    case F::log:
      return [](const Complex& z, const Vec2&) { return logarithm(z); };
    case F::sin:
      return [](const Complex& z, const Vec2&) { return sine(z); };
    case F::cos:
      return [](const Complex& z, const Vec2&) { return cosine(z); };
    case F::tan:
      return [](const Complex& z, const Vec2&) { return tangent(z); };
    case F::sinh:
      return [](const Complex& z, const Vec2&) { return hyperbolic_sine(z); };
    case F::cosh:
      return [](const Complex& z, const Vec2&) { return hyperbolic_cosine(z); };
    case F::tanh:
      return [](const Complex& z, const Vec2&) { return hyperbolic_tangent(z); };
    case F::asin:
      return [](const Complex& z, const Vec2&) { return arc_sine(z); };
    case F::acos:
      return [](const Complex& z, const Vec2&) { return arc_cosine(z); };
    case F::atan:
      return [](const Complex& z, const Vec2&) { return arc_tangent(z); };
    case F::asinh:
      return [](const Complex& z, const Vec2&) { return logarithm(z + square_root(z * z + 1.0)); };
    case F::acosh:
      return [](const Complex& z, const Vec2&) { return logarithm(z + square_root(z * z - 1.0)); };
    case F::atanh:
      return [](const Complex& z, const Vec2&) { return hyperbolic_arc_tangent(z); };
    default:
      return power_of;
  }
}

}  // namespace durer
