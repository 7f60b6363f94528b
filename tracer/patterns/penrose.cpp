// tiling 25, 26, 27: Penrose's tilings by descent through their inflations.
//
//   pigment { tiling 26 color_map { [0 rgb 1] [0.5 rgb 0] [0.5 rgb <1,.8,.2>] [1 rgb 0] } }
//
// The point is scaled into one large tile; each step says in which of the smaller tiles of the next
// generation it lies, until tiles have side 1. Source: spec/textures.md 8.1.
#include "tracer/patterns/penrose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace durer {
namespace {

constexpr double kPhi = std::numbers::phi, kPsi = 1 / kPhi;
constexpr double kSlack = 1e-6;
// Deeper than any double coordinate within 1e17 needs.
constexpr int kMaximumLevel = 400;

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

struct Complex {
  double re, im;
  friend Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
  friend Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
  friend Complex operator+(Complex a, double b) { return {a.re + b, a.im}; }
  friend Complex operator-(Complex a, double b) { return {a.re - b, a.im}; }
  friend Complex operator*(double s, Complex a) { return {s * a.re, s * a.im}; }
  friend Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
};
Complex conjugate(Complex w) { return {w.re, -w.im}; }
Complex up(Complex w) { return {w.re, std::abs(w.im)}; }
Complex unit(double degrees) {
  return {std::cos(radians(degrees)), std::sin(radians(degrees))};
}

// What every evaluation needs of the angles, computed once.
struct Constants {
  double cos36 = std::cos(radians(36)), cos72 = std::cos(radians(72));
  double cos108 = std::cos(radians(108));
  double tan18 = std::tan(radians(18)), tan54 = std::tan(radians(54));
  double tan72 = std::tan(radians(72)), tan108 = std::tan(radians(108));
  double tan126 = std::tan(radians(126)), tan144 = std::tan(radians(144));
  double tan162 = std::tan(radians(162)), tan36 = std::tan(radians(36));
  Complex e36 = unit(36), e_36 = unit(-36), e72 = unit(72), e_72 = unit(-72), e108 = unit(108),
          e_144 = unit(-144);
  double a = 1 / (2 * std::sin(radians(36)));  // circumradius of the unit pentagon
  double b = 1 / (2 * std::tan(radians(36)));  // its half height
};
const Constants k;

// Into the wedge of 36 degrees above the real axis.
Complex fold(Complex w) {
  w = up(w);
  const double size = std::sqrt(w.re * w.re + w.im * w.im);
  if (w.re < size * k.cos36) w = up(w * (w.re < size * k.cos108 ? k.e_144 : k.e_72));
  return w;
}

// Distance to the line through the real point q in the given direction.
double line_distance(Complex w, double q, double degrees) {
  return std::abs(std::sin(radians(degrees)) * (w.re - q) - std::cos(radians(degrees)) * w.im);
}

double kite_value(int number, Complex w) {
  if (number == 26) {
    return std::min(std::max({0.5 - 2.23 * line_distance(w, 0, 36),
                              0.5 - 2.23 * line_distance(w, 1, 108), 0.0}),
                    0.5 - kSlack);
  }
  if (w.im < (w.re - kPsi) * k.tan72) {
    return std::max({1 - 2.775 * line_distance(w, kPsi, 72), 1 - 2.775 * line_distance(w, 1, 108),
                     0.5 + kSlack});
  }
  return std::min(std::max({0.5 - 2.775 * std::abs(w.im), 0.5 - 2.775 * line_distance(w, kPsi, 72),
                            0.0}),
                  0.5 - kSlack);
}

double dart_value(int number, Complex w) {
  if (number == 26) {
    return std::max({1 - 2.23 * std::abs(w.im), 1 - 2.23 * line_distance(w, 1, 144),
                     0.5 + kSlack});
  }
  return std::min(std::max({0.5 - 2.775 * line_distance(w, 0, 36),
                            0.5 - 2.775 * line_distance(w, 1, 144), 0.0}),
                  0.5 - kSlack);
}

double kites_and_rhombs(int number, Complex w) {
  w = fold(w);
  if (number == 27) w = kPsi * w;
  const double distance =
      std::abs(std::sin(radians(108)) * w.re - std::cos(radians(108)) * w.im) /
      std::cos(radians(18));
  const int n = std::clamp(
      static_cast<int>(std::ceil(std::log(distance) / std::log(kPhi * kPhi))), 0,
      kMaximumLevel / 2);
  w = std::pow(kPhi, -2.0 * n) * w;
  if (n & 1) w = up(w * k.e_36);

  bool kite = true;
  for (int level = 2 * n;; --level) {
    w = up(w);
    if (level == 0) return kite ? kite_value(number, w) : dart_value(number, w);
    if (kite) {
      if (w.im < (w.re - kPsi) * k.tan144) {
        w = kPhi * w;
        kite = false;
      } else {
        w = kPhi * (k.e108 * (w - k.e36));
      }
    } else if (w.im < (w.re - kPsi) * k.tan108) {
      w = kPhi * (k.e_36 * w);
      kite = true;
    } else {
      w = kPhi * (k.e_144 * (w - 1));
    }
  }
}

enum class Part {
  pentagon1, pentagon2_quad, pentagon2_plain, pentagon3_wedge, pentagon3_plain, star, boat_wedge,
  boat_plain, diamond_a, diamond_b,
};

double kept_in_class(double v, int c) {
  return std::clamp(v, c / 6.0 + kSlack, (c + 1) / 6.0 - kSlack);
}

double pentagon_value(Part part, Complex w) {
  const double slope = 5.55 * kPsi;
  const auto side = [&](Complex v) { return std::abs(v.re - k.b) * slope; };
  switch (part) {
    case Part::pentagon1:
      return std::min(std::max((1 - side(fold(w))) / 6, 0.0), 1.0 / 6 - kSlack);
    case Part::pentagon2_quad:
    case Part::pentagon2_plain: return kept_in_class((2 - side(fold(w))) / 6, 1);
    case Part::pentagon3_wedge:
    case Part::pentagon3_plain: return kept_in_class((3 - side(fold(w))) / 6, 2);
    case Part::star:
      return kept_in_class((4 - slope * line_distance(w, kPhi * k.a, 162)) / 6, 3);
    case Part::boat_wedge:
    case Part::boat_plain: {
      const double edge1 = std::abs(w.re - kPsi * k.a * k.cos72) * slope;
      const double edge2 = slope * line_distance(fold(-1.0 * conjugate(w)), kPhi * k.a, 162);
      return std::min(std::max({(5 - edge1) / 6, (5 - edge2) / 6, 4.0 / 6 + kSlack}),
                      5.0 / 6 - kSlack);
    }
    case Part::diamond_a:
    case Part::diamond_b:
      return kept_in_class((6 - slope * line_distance(w, -kPsi * k.a, 18)) / 6, 5);
  }
  return 0;
}

// One step of the descent: the smaller tile and the point in its frame.
Part descend(Part part, Complex& w) {
  const double psi2a = kPsi * kPsi * k.a;
  switch (part) {
    case Part::pentagon1:
      w = fold(w);
      if (w.im < (w.re - k.b) * k.tan54 + 0.5) {
        w = kPhi * (w - k.b - kPsi * k.a * k.cos72);
        return Part::pentagon2_plain;
      }
      w = kPhi * (k.e_36 * w);
      return Part::star;
    case Part::pentagon2_quad:
      if (w.im < (w.re - psi2a) * k.tan54) {
        w = kPhi * (w - k.a);
        return Part::pentagon1;
      }
      if (w.im < (w.re - psi2a) * k.tan162) {
        w = -kPhi * conjugate(w);
        return Part::diamond_a;
      }
      w = kPhi * (k.e108 * w + kPsi * k.a);
      return Part::pentagon2_quad;
    case Part::pentagon2_plain:
      if (w.im < (w.re + k.a) * k.tan18) {
        w = kPhi * (w + k.a - psi2a);
        return Part::diamond_b;
      }
      w = kPhi * (-1.0 * conjugate(k.e_36 * w) - k.a * k.e72);
      return Part::pentagon3_plain;
    case Part::pentagon3_wedge:
      if (w.re > psi2a * k.cos72) {
        w = -kPhi * conjugate(w - psi2a * k.cos72 - kPsi * k.b);
        return Part::pentagon2_quad;
      }
      w = kPhi * w;
      return Part::boat_wedge;
    case Part::pentagon3_plain:
      if (w.re < k.a * k.cos108) {
        w = kPhi * (k.e_144 * w - k.a);
        return Part::pentagon2_plain;
      }
      if (w.im > (w.re - psi2a) * k.tan126) {
        w = kPhi * (-1.0 * conjugate(k.e36 * w) - k.a * k.e72);
        return Part::pentagon3_plain;
      }
      w = kPhi * w;
      return Part::boat_plain;
    case Part::star:
      if (w.re < kPsi * k.b) {
        w = kPhi * w;
        return Part::pentagon1;
      }
      w = -kPhi * conjugate(w - 2 * kPsi * k.b);
      return Part::pentagon3_wedge;
    case Part::boat_wedge:
      if (w.re > kPhi * k.a * k.cos108) {
        w = -kPhi * conjugate(w);
        return Part::pentagon1;
      }
      w = kPhi * (w + k.a);
      return Part::pentagon3_wedge;
    case Part::boat_plain:
      w = kPhi * (k.e72 * w + k.a);
      return Part::pentagon3_wedge;
    case Part::diamond_a: w = kPhi * w; return Part::pentagon1;
    case Part::diamond_b: w = kPhi * w; return Part::pentagon3_wedge;
  }
  return part;
}

double pentagons(Complex w) {
  w = fold(w);
  const double distance = 2 * k.tan36 * w.re;
  const int n = std::clamp(
      static_cast<int>(std::ceil(std::log(distance) / std::log(std::pow(kPhi, 4)))), 0,
      kMaximumLevel / 4);
  w = std::pow(kPhi, -4.0 * n) * w;
  Part part = Part::pentagon1;
  for (int level = 4 * n; level > 0; --level) {
    w = up(w);
    part = descend(part, w);
  }
  return pentagon_value(part, up(w));
}

}  // namespace

double penrose_tiling(int number, double x, double z) {
  if (x * x + z * z <= 1e-20) return 1;
  return number == 25 ? pentagons({x, z}) : kites_and_rhombs(number, {x, z});
}

}  // namespace durer
