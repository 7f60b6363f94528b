// An area light's grid of samples (spec/shading.md 9.3).
#pragma once

#include "tracer/lights/light.h"

namespace durer {

// Some samples of a grid, worked out at once: by one instruction, where processors have one for four.
struct AreaSamples {
  static constexpr int kCount = 4;

  double u[kCount], v[kCount];  // column and row, with jitter
  // As seen from a point: unit directions, distances.
  double x[kCount], y[kCount], z[kCount];
  double distance[kCount];

  void put(int slot, int column, int row) {
    u[slot] = column;
    v[slot] = row;
  }
  // By up to half a column and a row aside; `random`: 64 random bits.
  void displace(int slot, uint64_t random) {
    u[slot] += static_cast<double>(random >> 32) * 0x1p-32 - 0.5;
    v[slot] += static_cast<double>(random & 0xffffffffu) * 0x1p-32 - 0.5;
  }
  LightDirection direction(int slot) const {
    return {{x[slot], y[slot], z[slot]}, distance[slot]};
  }
};

// The grid as seen from one point.
struct AreaLightGrid {
  AreaLightGrid(const Light& light, const Vec3& seen_from);

  double step1, step2;  // from one sample to the next, in axes; 0: one row or column only
  bool circular, directed;
  Vec3 center, axis1, axis2;  // axes after `orient`
  Vec3 point;
  Vec3 rays_come_to;  // the point; of directed lights where all rays from a sample run to
};

// Fills in what samples look like from their columns and rows.
void look_at_samples(const AreaLightGrid& grid, AreaSamples& samples);

}  // namespace durer
