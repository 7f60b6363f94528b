#include "tracer/lights/area_light_grid.h"

#include <cmath>

#include "tracer/math/kernel.h"

namespace durer {

AreaLightGrid::AreaLightGrid(const Light& light, const Vec3& seen_from)
    : step1(light.grid_step1()),
      step2(light.grid_step2()),
      circular(light.node().circular),
      directed(light.is_directed()),
      center(light.node().location),
      axis1(light.node().axis1),
      axis2(light.node().axis2),
      point(seen_from),
      rays_come_to(directed ? light.node().point_at : seen_from) {
  if (!light.node().orient) return;
  // Turn the disc towards the point; its diameter is the first axis.
  const Vec3 towards = light.direction_from(point, center).direction;
  const Vec3 helper = std::abs(std::abs(towards.z) - 1) < 0.01 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const double diameter = length(axis1);
  const Vec3 first = normalize_or_zero(cross(towards, helper));
  axis1 = first * diameter;
  axis2 = normalize_or_zero(cross(towards, first)) * diameter;
}

// Loops over the slots, which the compiler turns into instructions for four.
DURER_KERNEL void look_at_samples(const AreaLightGrid& grid, AreaSamples& s) {
  constexpr int kCount = AreaSamples::kCount;
  double u[kCount], v[kCount];
  for (int k = 0; k < kCount; ++k) {
    u[k] = grid.step1 > 0 ? s.u[k] * grid.step1 - 0.5 : 0.0;
    v[k] = grid.step2 > 0 ? s.v[k] * grid.step2 - 0.5 : 0.0;
  }
  if (grid.circular) {
    // The square becomes a disc.
    for (int k = 0; k < kCount; ++k) {
      u[k] += 0.001;
      v[k] += 0.001;
      const double a = std::abs(u[k]), b = std::abs(v[k]);
      const double scale = (a > b ? a : b) / std::sqrt(u[k] * u[k] + v[k] * v[k]);
      u[k] *= scale;
      v[k] *= scale;
    }
  }
  double x[kCount], y[kCount], z[kCount];
  for (int k = 0; k < kCount; ++k) {
    x[k] = grid.center.x + u[k] * grid.axis1.x + v[k] * grid.axis2.x;
    y[k] = grid.center.y + u[k] * grid.axis1.y + v[k] * grid.axis2.y;
    z[k] = grid.center.z + u[k] * grid.axis1.z + v[k] * grid.axis2.z;
  }
  for (int k = 0; k < kCount; ++k) {
    const double dx = x[k] - grid.rays_come_to.x;
    const double dy = y[k] - grid.rays_come_to.y;
    const double dz = z[k] - grid.rays_come_to.z;
    const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double scale = distance > 0 ? 1 / distance : 1.0;
    s.x[k] = dx * scale;
    s.y[k] = dy * scale;
    s.z[k] = dz * scale;
    s.distance[k] = distance;
  }
  if (grid.directed) {
    for (int k = 0; k < kCount; ++k) {
      s.distance[k] = (x[k] - grid.point.x) * s.x[k] + (y[k] - grid.point.y) * s.y[k] +
                      (z[k] - grid.point.z) * s.z[k];
    }
  }
}

}  // namespace durer
