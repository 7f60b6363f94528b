// The surfaces of functions.inc, each with the formula of spec/functions.md 4.2.
//
//   #include "functions.inc"
//   isosurface { function { f_torus(x, y, z, 0.6, 0.25) } threshold 0 max_gradient 1.5 }
//
// Notation: X = x^2, Y = y^2, Z = z^2, r2 = X+Y+Z; limited() clamps to -10..10.
#include "tracer/functions/internal_surfaces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace durer {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

double limited(double v) { return std::min(10.0, std::max(v, -10.0)); }
double square(double v) { return v * v; }
double cube(double v) { return v * v * v; }
double positive_fmod(double v, double period) {
  const double m = std::fmod(v, period);
  return m < 0 ? m + period : m;
}

// A point with its squares and the extra parameters p1, p2, ...
struct Arguments {
  double x, y, z, X, Y, Z;
  double p1, p2, p3, p4, p5, p6, p7, p8, p9, p10;

  // Reads as many parameters as the function has.
  Arguments(const double* a, int count)
      : x(a[0]), y(a[1]), z(a[2]), X(x * x), Y(y * y), Z(z * z) {
    double* const p[] = {&p1, &p2, &p3, &p4, &p5, &p6, &p7, &p8, &p9, &p10};
    for (int i = 0; i < 10; ++i) *p[i] = i < count ? a[3 + i] : 0;
  }
  double r2() const { return X + Y + Z; }
  // The step "surface of revolution": a curve in the xy plane turned about y.
  void revolve(double enabled, double offset, double degrees) {
    if (!(enabled > 0)) return;
    const double rho = std::sqrt(X + Z) - offset;
    if (degrees != 0) {
      const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
      x = rho * c - y * s;
      y = rho * s + y * c;
    } else {
      x = rho;
    }
    X = x * x;
    Y = y * y;
  }
};

// Round, square or superelliptic cross sections.
double cross_section(double a, double b, double shape) {
  if (shape == 1) return std::sqrt(a * a + b * b);
  if (shape == 0) return std::max(std::abs(a), std::abs(b));
  return std::pow(std::pow(std::abs(a), 2 / shape) + std::pow(std::abs(b), 2 / shape), shape / 2);
}

// Three exponentials of crossed ellipsoids.
struct Ellipsoids {
  double e1, e2, e3;
  explicit Ellipsoids(const Arguments& a)
      : e1(std::exp(-a.p2 * (a.p1 * a.X + a.p1 * a.Y + a.Z))),
        e2(std::exp(-a.p2 * (a.p1 * a.X + a.Y + a.p1 * a.Z))),
        e3(std::exp(-a.p2 * (a.X + a.p1 * a.Y + a.p1 * a.Z))) {}
};

double hexagon_distances(const Arguments& a, double& along_x, double& along_y) {
  const double root3 = std::numbers::sqrt3;
  double u = std::abs(std::fmod(std::abs(a.x), root3) - root3 / 2);
  double v = std::abs(std::fmod(std::abs(a.y), 3.0) - 1.5);
  const double c = root3 / 2 - u, d = 1.5 - v;
  if (u * u + v * v > c * c + d * d) u = c, v = d;
  along_x = u;
  along_y = v;
  return std::atan2(v, u);
}

double cushion(const double* v) {
  const Arguments a(v, 1);
  const double z = a.z, X = a.X, Y = a.Y, Z = a.Z;
  return limited(a.p1 * (Z * X - Z * Z - 2 * z * X + 2 * Z * z + X - Z - square(X - z) - Y * Y -
                         2 * X * Y - Y * Z + 2 * Y * z + Y));
}

double mesh1(const double* v) {
  const Arguments a(v, 5);
  const auto saw = [&](double at, double d) { return std::abs(positive_fmod(at, 2 * d) - d) * a.p3; };
  const auto hypotenuse = [](double s, double t) { return std::sqrt(s * s + t * t); };
  const double s = a.p4 * std::cos(kPi * a.z / a.p2), t = a.p4 * std::cos(kPi * a.x / a.p1);
  return std::min(std::min(hypotenuse((a.y - s) * a.p5, saw(a.x, a.p1)),
                           hypotenuse((a.y + s) * a.p5, saw(a.x - a.p1, a.p1))),
                  std::min(hypotenuse((a.y + t) * a.p5, saw(a.z, a.p2)),
                           hypotenuse((a.y - t) * a.p5, saw(a.z - a.p2, a.p2))));
}

double helical_torus(const double* v) {
  Arguments a(v, 10);
  const double rho = std::sqrt(a.X + a.Z);
  if (a.x == 0 && a.z == 0) a.x = 1e-6;
  const double phi = std::atan2(a.x, a.z), psi = std::atan2(rho - a.p1, a.y);
  const double r = std::sqrt(square(rho - a.p1) + a.Y);
  const double theta = positive_fmod(phi * a.p2 + psi * a.p3, 2 * kPi) - kPi;
  double w = std::atan2(theta * a.p9, r - a.p6);
  w = std::cos(w * a.p8 + phi * a.p10) * a.p4 + a.p5;
  const double tube = w - std::min(std::sqrt(square(r - a.p6) + theta * theta * a.p7), r + a.p6);
  return -std::max(a.p5 + a.p6 - a.p1 - rho, tube);
}

double helix1(const double* v) {
  Arguments a(v, 7);
  const double rho = std::sqrt(a.X + a.Z);
  if (a.x == 0 && a.z == 0) a.x = 1e-6;
  const double theta = positive_fmod(std::atan2(a.z, a.x) * a.p1 + a.y * a.p2 * a.p1, 2 * kPi);
  double across = rho - a.p4;
  double along = (theta - kPi) / a.p5 / (a.p2 * a.p1);
  if (a.p6 != 1 && a.p7 != 0) {
    const double c = std::cos(a.p7 * kDegree), s = std::sin(a.p7 * kDegree);
    const double turned = across * c - along * s;
    along = across * s + along * c;
    across = turned;
  }
  return -a.p3 + std::min(a.p4 + rho, cross_section(across, along, a.p6));
}

double helix2(const double* v) {
  const Arguments a(v, 7);
  const double t = a.y * a.p2, c = std::cos(t), s = std::sin(t);
  const double u = a.x - a.p4 * c, w = a.z - a.p4 * s;
  return cross_section(u * c + w * s, -u * s + w * c, a.p6) - a.p3;
}

double spiral(const double* v) {
  Arguments a(v, 6);
  const double rho = std::sqrt(a.X + a.Z);
  if (a.x == 0 && a.z == 0) a.x = 1e-6, a.X = a.x * a.x;
  const double theta = std::atan2(a.z, a.x);
  const double across = std::fmod(rho + a.p1 * theta / (2 * kPi), a.p1) - a.p1 / 2;
  const double r = std::sqrt(a.r2());
  return -std::min(a.p3 - r, a.p2 - std::min(cross_section(across, a.y, a.p6), r));
}

double polytubes(const double* v) {
  const Arguments a(v, 6);
  const double radius = a.p2 + a.p3 * a.y + a.p4 * a.Y + a.p5 * a.Y * a.y + a.p6 * a.Y * a.Y;
  double least = 10000;
  // More tubes than a picture could show would only hang.
  const int tubes = static_cast<int>(std::min(a.p1, 1e6));
  for (int i = 0; i < tubes; ++i) {
    const double angle = 2 * kPi * i / a.p1;
    least = std::min(least, std::sqrt(square(a.x - radius * std::sin(angle)) +
                                      square(a.z - radius * std::cos(angle))));
  }
  return least;
}

double dupin_cyclid(const double* v) {
  const Arguments a(v, 6);
  const double k = square(a.p6), h = square(a.p3), t = square(a.p5), r2 = a.r2();
  const double e = h - t - square(a.p4 + a.p2), f = h - t - square(a.p4 - a.p2);
  return limited(-a.p1 *
                 (e * f * r2 * r2 +
                  2 * k *
                      ((h + square(a.p2) - t - square(a.p4)) *
                           (2 * a.p4 * a.x + 2 * a.p5 * a.y - k) -
                       4 * a.p5 * h * a.y) *
                      r2 +
                  4 * k * k * (a.p4 * a.x + a.p5 * a.y) * (a.p4 * a.x + a.p5 * a.y - k) +
                  4 * k * k * square(a.p2) * a.Y + square(square(k))));
}

double boy_surface(const double* v) {
  const Arguments a(v, 2);
  const double u = 1 - a.z, h = a.X + a.Y, Z = a.Z, root2 = std::numbers::sqrt2;
  return limited(
      a.p1 * a.p2 *
      (64 * cube(u) * cube(a.z) - 48 * u * u * Z * (3 * h + 2 * Z) +
       12 * u * a.z *
           (27 * h * h - 24 * Z * h + 36 * root2 * a.y * a.z * (a.Y - 3 * a.X) + 4 * Z * Z) +
       (9 * h - 2 * Z) *
           (-81 * h * h - 72 * Z * h + 108 * root2 * a.x * a.z * (a.X - 3 * a.Y) + 4 * Z * Z)));
}

double comma(const double* v) {
  Arguments a(v, 1);
  if (a.x == 0 && a.z == 0) a.x = 1e-4;
  const double p = a.p1, theta = std::atan2(a.z, a.x);
  const double r = std::sqrt(square(a.x + p / 4) + a.Z);
  const double tail = std::min(
      a.z, p / 2 * std::cos(theta / 2) - std::sqrt(square(r - 0.75 * p) + a.Y));
  const double head = p / 2 - std::sqrt(square(a.x - p / 2) + a.Z + a.Y);
  return -std::max(tail, head);
}

double enneper(const double* v) {
  const Arguments a(v, 1);
  const double w = std::abs(a.z) < 0.2 ? 0.2 : a.z;
  const double s = (a.Y - a.X) / (2 * w) + 2 * a.Z / 9, t = (a.Y - a.X) / (4 * w);
  return limited(-a.p1 * (cube(s) - 6 * t * t));
}

double quantum(const double* v) {
  Arguments a(v, 1);
  if (a.x == 0 && a.z == 0) a.x = 1e-6;
  const double rho = std::sqrt(a.x * a.x + a.Z), c = std::cos(std::atan2(rho, a.y));
  const double r = 2 * std::sqrt(rho * rho + a.Y);
  return -0.1 * (square(r * r * std::exp(-0.33333333 * r) * (3 * c * c - 1)) - 12);
}

#define FORMULA(count) [](const double* v) -> double { \
  Arguments a(v, count);                               \
  [[maybe_unused]] double &x = a.x, &y = a.y, &z = a.z, &X = a.X, &Y = a.Y, &Z = a.Z; \
  [[maybe_unused]] const double p1 = a.p1, p2 = a.p2, p3 = a.p3, p4 = a.p4, p5 = a.p5, p6 = a.p6;
#define END }

const InternalSurface kSurfaces[] = {
    {0, 5, FORMULA(5) a.revolve(p3, p4, p5); x = std::abs(x);
     return -std::min(p2, std::max(-p1 * (X * x - X + Y), -p2)); END},
    {1, 5, FORMULA(5) a.revolve(p3, p4, p5);
     return std::min(p2, std::max(-p1 * (2 * X * X - 3 * X * y + Y - 2 * Y * y + Y * Y), -p2)); END},
    {2, 5, FORMULA(5) a.revolve(p3, p4, p5);
     return std::min(p2, std::max(-p1 * (X * X + X * Y - 2 * X * y - x * Y + Y), -p2)); END},
    {3, 5, FORMULA(5) a.revolve(p3, p4, p5);
     return std::min(
         p2, std::max(-p1 * (X * X + Y * Y + 2 * X * Y + 3 * X * y - Y * y), -p2)); END},
    {4, 2, FORMULA(2) const double q = X + Z;
     return limited(p1 * (Y * (p2 * p2 - q) - square(q + 2 * p2 * y - p2 * p2))); END},
    {5, 2, FORMULA(2) return limited(-p1 * (square(a.r2()) - p2 * (X + Z) * y)); END},
    {6, 5, FORMULA(5)
     const double A = std::min(1.0, (square(x + p1 / 2) + Y + Z) * p3 * p3);
     const double B = std::min(1.0, (square(x - p1 / 2) + Y + Z) * p5 * p5);
     return -(p2 * square(1 - A) + p4 * square(1 - B)); END},
    {7, 4, FORMULA(4)
     return p4 - p3 * (std::exp(-p2 * a.r2()) + std::exp(-p2 * (square(x - p1) + Y + Z))); END},
    {8, 2, boy_surface},
    {9, 1, comma},
    {10, 4, FORMULA(4) const Ellipsoids e(a); return p4 - p3 * std::max({e.e1, e.e2, e.e3}); END},
    {11, 1, FORMULA(1) return limited(p1 * (X * Z - y)); END},
    {12, 1, FORMULA(1) return limited(-p1 * (X * x - Y * y - z)); END},
    {13, 1, cushion},
    {14, 1, FORMULA(1)
     return limited(-p1 * (X * X + 2 * X * Z - 0.36 * X - Y * Y + 0.25 * Y + Z * Z)); END},
    {15, 6, FORMULA(6) a.revolve(p4, p5, p6);
     return limited(-p1 * (X * (X - p2 * p2) - Y * (Y - p3 * p3))); END},
    {16, 6, dupin_cyclid},
    {17, 3, FORMULA(3) return std::sqrt(X * p1 * p1 + Y * p2 * p2 + Z * p3 * p3); END},
    {18, 1, enneper},
    {19, 4, FORMULA(4) const Ellipsoids e(a); return p4 - p3 * (e.e1 + e.e2 + e.e3); END},
    {20, 3, FORMULA(3)
     return limited(p1 * ((Y + Z) * (1 + (p3 - 4 * p2) * x) + X * (1 + p3))); END},
    {21, 6, FORMULA(6) a.revolve(p4, p5, p6);
     return limited(-p1 * (Y * (1 + (p3 - 4 * p2) * x) + X * (1 + p3))); END},
    {22, 1, FORMULA(1) return limited(p1 * (0.5 * X * X * x + 0.5 * X * X - Y - Z)); END},
    {23, 1, FORMULA(1)
     return limited(-p1 * (cube(2 * X + Y + Z - 1) - 0.1 * X * Z * z - Y * Z * z)); END},
    {24, 10, helical_torus},
    {25, 7, helix1},
    {26, 7, helix2},
    {27, 1, FORMULA(1) double s, t;
     const double angle = hexagon_distances(a, s, t);
     return angle < kPi / 6 ? s : std::cos(kPi / 3) * s + std::sin(kPi / 3) * t; END},
    {28, 1, FORMULA(1) double s, t;
     const double angle = hexagon_distances(a, s, t);
     return angle < kPi / 6 ? t : std::abs(-std::sin(kPi / 3) * s + std::cos(kPi / 3) * t); END},
    {30, 1, FORMULA(1)
     return limited(
         -p1 * (4 * cube(a.r2() - 13) + 27 * square(3 * X + Y - 4 * Z - 12))); END},
    {31, 3, FORMULA(3) const double h = p2 * p2, t = p3 * p3;
     return limited(-p1 * (X * X + 2 * X * Y - 2 * X * Z - 2 * (h + t) * X + Y * Y - 2 * Y * Z +
                           2 * (h - t) * Y + Z * Z + 2 * (h + t) * Z + square(h - t))); END},
    {32, 4, FORMULA(4) const Ellipsoids e(a); return p4 - p3 * std::min({e.e1, e.e2, e.e3}); END},
    {33, 3, FORMULA(3)
     return limited(-p1 * (Y + Z - p3 * p3 * X * X + p3 * p3 * p2 * p2 * X)); END},
    // Sic: p3 three times.
    {34, 6, FORMULA(6) a.revolve(p4, p5, p6);
     return limited(-p1 * (Y - p3 * p3 * X * X + p3 * p3 * p2 * p3 * X)); END},
    {35, 1, FORMULA(1) const double s = a.r2(), t = s - 2 * y - 1;
     return limited(-p1 * ((s + 2 * y - 1) * (t * t - 8 * Z) + 16 * x * z * t)); END},
    {36, 1, FORMULA(1)
     return limited(
         -p1 * (X * X + Y * Y + Z * Z - X - Y - Z - X * Y - X * Z - Y * Z + 1)); END},
    {37, 4, FORMULA(4)
     return limited(-p1 * (X * X + Y * Y + Z * Z + p2 * (X + Y + Z) + p3 * (X * Y + X * Z + Y * Z) +
                           p4 * x * y * z - 1)); END},
    {38, 1, FORMULA(1) return limited(-p1 * (X * X - X + Y + Z)); END},
    {39, 6, FORMULA(6) a.revolve(p4, p5, p6);
     return limited(-p1 * (Y - p3 * p3 * p2 * p2 * X + p3 * p3 * X * X)); END},
    {40, 5, mesh1},
    {41, 1, FORMULA(1) return limited(-p1 * (4 * X * a.r2() - Y * (1 - Y - Z))); END},
    {42, 1, FORMULA(1) return limited(-p1 * (Y * y + Z * z - 6 * y * z)); END},
    {43, 1, cushion},
    {44, 4, FORMULA(4)
     return limited(-p1 * (square(a.r2() + p2 * p2) - p4 * p2 * p2 * (X + Z) - p3 * p3)); END},
    {45, 1, FORMULA(1) return limited(-p1 * (X - y + Z)); END},
    {46, 3, FORMULA(3) const double h = p2 * p2, t = p3 * p3;
     return limited(-p1 * (X * X + 2 * X * Y - 2 * X * z - (h + t) * X + Y * Y - 2 * Y * z +
                           (h - t) * Y + Z + (h + t) * z + square(h - t))); END},
    {47, 0, FORMULA(0) return std::atan2(std::sqrt(X + Z), y); END},
    {48, 1, FORMULA(1) return limited(p1 * (X * X + Y * Y + Z * Z - (X + Y + Z))); END},
    {49, 1, FORMULA(1) return -limited(-p1 * (X * X - X * x + Y + Z)); END},
    {50, 7, FORMULA(7) a.revolve(p5, p6, a.p7);
     return limited(-p1 * (Y - p2 * p4 * p4 * X * x - p3 * p4 * p4 * X * X)); END},
    {51, 5, FORMULA(5)
     return std::sqrt(X + Z) -
            std::max(-5.0, p1 + p2 * y + p3 * Y + p4 * Y * y + p5 * Y * Y); END},
    {52, 6, polytubes},
    {53, 1, quantum},
    {54, 1, FORMULA(1) return limited(-p1 * (X * X + Z * Z - y)); END},
    {55, 1, FORMULA(1) return limited(-p1 * (X * X - Z * Z - y)); END},
    {56, 3, FORMULA(3) const double q = X + Z;
     return limited(-p1 * (q * Y + p3 * p3 * q - p3 * p3 * p2 * p2)); END},
    {57, 0, FORMULA(0) return std::sqrt(a.r2()); END},
    {60, 4, FORMULA(4)
     const double d1 = std::max(0.0, std::abs(x) - (p2 - p1));
     const double d2 = std::max(0.0, std::abs(y) - (p3 - p1));
     const double d3 = std::max(0.0, std::abs(z) - (p4 - p1));
     return std::sqrt(d1 * d1 + d2 * d2 + d3 * d3) - p1 - 1e-6; END},
    {61, 1, FORMULA(1) return std::sqrt(a.r2()) - p1; END},
    {62, 5, FORMULA(5) const Ellipsoids e(a);
     return -p3 * (p5 * std::exp(-p4 * a.r2()) - e.e1 - e.e2 - e.e3); END},
    {63, 4, FORMULA(4)
     return y - p1 * std::cos(p2 * x) * std::cos(p3 * z) * std::exp(-p4 * (X + Z)); END},
    {64, 6, spiral},
    {65, 1, FORMULA(1) return limited(-p1 * (X * Y + X * Z + Y * Z + x * y * z)); END},
    {66, 4, FORMULA(4)
     return limited(-p1 * ((p3 - x) * (Y + Z) - p4 * p4 * p2 * X - p4 * p4 * X * x)); END},
    {67, 7, FORMULA(7) a.revolve(p5, p6, a.p7);
     return limited(-p1 * ((p3 - x) * Y - p4 * p4 * p2 * X - p4 * p4 * X * x)); END},
    {68, 2, FORMULA(2)
     return 1 - std::pow(std::pow(std::pow(std::abs(x), 2 / p1) + std::pow(std::abs(y), 2 / p1),
                                  p1 / p2) +
                             std::pow(std::abs(z), 2 / p2),
                         p2 / 2); END},
    {69, 0, FORMULA(0) return std::atan2(x, z); END},
    {70, 2, FORMULA(2) return std::sqrt(square(std::sqrt(X + Z) - p1) + Y) - p2; END},
    {71, 3, FORMULA(3) const double h = p2 * p2, t = p3 * p3;
     return limited(-p1 * (square(a.r2()) - 2 * (h + t) * (X + Z) + 2 * (h - t) * Y +
                           square(h - t))); END},
    {72, 1, FORMULA(1) const double w = Y + Z;
     return limited(-p1 * (4 * (X * X + w * w) + 17 * X * w - 20 * (X + w) + 17)); END},
    {73, 1, FORMULA(1) return limited(-p1 * (X - y * Z)); END},
    {74, 2, FORMULA(2) return limited(-p1 * (p2 * (y - 1) + (X + Z) * y)); END},
    {75, 6, FORMULA(6) a.revolve(p4, p5, p6);
     return limited(-p1 * (p2 * p2 * y + X * y - p3)); END},
    // The hook of pattern functions: nothing is attached to it (1.5).
    {77, 0, FORMULA(0) return 0; END},
};
#undef FORMULA
#undef END

}  // namespace

const InternalSurface* find_internal_surface(int number) {
  const auto* const found = std::find_if(std::begin(kSurfaces), std::end(kSurfaces),
                                         [&](const auto& s) { return s.number == number; });
  return found == std::end(kSurfaces) ? nullptr : found;
}

}  // namespace durer
