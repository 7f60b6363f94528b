// Transforms and warp{} items (spec/textures.md 5). All but turbulence, which needs noise.
#include <cmath>

#include "tracer/patterns/noise.h"
#include "tracer/patterns/pattern.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

double azimuth(double x, double z) {
  if (z == 0) return x > 0 ? 0 : M_PI;
  const double angle = std::acos(x / std::sqrt(x * x + z * z));
  return z < 0 ? 2 * M_PI - angle : angle;
}

double power_or_one(double base, double exponent) {
  return exponent == 0 ? 1 : std::pow(base, exponent);
}

Vec3 oriented(const Vec3& o, const Vec3& p) {
  if (o.x == 0 && o.y == 0 && o.z == 1) return p;
  return {o.x * p.z + o.y * p.x + o.z * p.x, o.x * p.y - o.y * p.z + o.z * p.y,
          -o.x * p.x + o.y * p.y + o.z * p.z};
}

Vec3 warp(const Transform& t, const Vec3& p) { return t.inverse_point(p); }

Vec3 warp(const Turbulence& t, const Vec3& p) {
  return p + t.strength * vector_turbulence(p, t.octaves, t.omega, t.lambda);
}

Vec3 warp(const RepeatWarp& w, Vec3 p) {
  const float block = static_cast<float>(std::floor(p[w.axis] / w.width));
  p[w.axis] -= static_cast<double>(block * w.width);
  if (static_cast<int64_t>(block) & 1) {
    for (int i = 0; i < 3; ++i) {
      if (w.flip[i] != 0) p[i] = -p[i];
    }
    if (w.flip[w.axis] != 0) p[w.axis] += w.width;
  }
  return p + static_cast<double>(block) * w.offset;
}

Vec3 warp(const BlackHoleWarp& w, Vec3 p) {
  Vec3 center = w.center;
  if (w.has_repeat) {
    Vec3 block(0);
    for (int i = 0; i < 3; ++i) {
      if (w.repeat[i] >= kEpsilon) block[i] = std::floor(p[i] / w.repeat[i]);
    }
    if (w.has_uncertainty) center += w.uncertainty * random_vector_of_cell(block);
    center += w.repeat * block;
  }
  const Vec3 away = p - center;
  const double distance = length(away);
  if (distance >= w.radius || w.type != 0) return p;
  const double pull = std::min(
      1.0, std::pow((w.radius - distance) / w.radius, w.power) * w.strength);
  return w.inverted ? p - pull * away : p + pull * away;
}

Vec3 warp(const PlanarWarp& w, const Vec3& p) {
  return oriented(w.orientation, {p.x, p.y, w.distance});
}

Vec3 warp(const CylindricalWarp& w, const Vec3& p) {
  const double radius = std::sqrt(p.x * p.x + p.z * p.z);
  if (radius == 0) return p;
  const double theta = azimuth(p.x, p.z) / (2 * M_PI);
  return oriented(w.orientation,
                  {theta * power_or_one(radius, w.distance_exponent), p.y, radius});
}

Vec3 warp(const SphericalWarp& w, const Vec3& p) {
  const double distance = length(p);
  if (distance == 0) return p;
  const Vec3 unit = p / distance;
  const double radius = std::sqrt(unit.x * unit.x + unit.z * unit.z);
  const double phi = 0.5 + std::asin(unit.y) / M_PI;
  const double theta = radius == 0 ? 0 : azimuth(unit.x, unit.z) / (2 * M_PI);
  const double scale = power_or_one(distance, w.distance_exponent);
  return oriented(w.orientation, {theta * scale, phi * scale, distance});
}

Vec3 warp(const ToroidalWarp& w, const Vec3& p) {
  const double radius = std::sqrt(p.x * p.x + p.z * p.z);
  if (radius == 0) return p;
  const double theta = azimuth(p.x, p.z) / (2 * M_PI);
  const double rho = radius - w.major_radius;
  const double q = std::sqrt(rho * rho + p.y * p.y);
  double phi = std::acos(-rho / q);
  if (p.y > 0) phi = 2 * M_PI - phi;
  phi /= 2 * M_PI;
  const double scale = power_or_one(q, w.distance_exponent);
  return oriented(w.orientation, {theta * scale, phi * scale, q});
}

// Unfolds the cube; the first face whose condition holds.
Vec3 warp(const CubicWarp&, const Vec3& p) {
  const double ax = std::abs(p.x), ay = std::abs(p.y), az = std::abs(p.z);
  auto u = [](double a) { return (a + 1) / 2; };
  if (p.x >= 0 && p.x >= ay && p.x >= az) {
    return {0.75 - u(p.z / p.x) / 4, 1.0 / 3 + u(p.y / p.x) / 3, p.x};
  }
  if (p.y >= 0 && p.y >= ax && p.y >= az) {
    return {0.25 + u(p.x / p.y) / 4, 1 - u(p.z / p.y) / 3, p.y};
  }
  if (p.z >= 0 && p.z >= ax && p.z >= ay) {
    return {0.25 + u(p.x / p.z) / 4, 1.0 / 3 + u(p.y / p.z) / 3, p.z};
  }
  if (p.x < 0 && -p.x >= ay && -p.x >= az) return {u(p.z / ax) / 4, 1.0 / 3 + u(p.y / ax) / 3, ax};
  if (p.y < 0 && -p.y >= ax && -p.y >= az) return {0.25 + u(p.x / ay) / 4, u(p.z / ay) / 3, ay};
  return {1 - u(p.x / az) / 4, 1.0 / 3 + u(p.y / az) / 3, az};
}

}  // namespace

Vec3 apply_warps(const std::vector<Warp>& warps, Vec3 p) {
  for (auto it = warps.rbegin(); it != warps.rend(); ++it) {
    p = std::visit([&](const auto& w) { return warp(w, p); }, *it);
  }
  return kept_near(p);
}

}  // namespace durer
