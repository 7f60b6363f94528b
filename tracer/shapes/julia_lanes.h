// Orbits of quaternions side by side. Chains of iterations leave a processor idle; eight of them do not.
// Each rounds like an orbit of its own. (All of it is built into the kernels of quaternion_walk.cpp.)
#pragma once

#include <immintrin.h>

#include <cmath>
#include <cstdint>

#include "tracer/math/kernel.h"
#include "tracer/shapes/julia_maps.h"

namespace durer {

using Row = double __attribute__((vector_size(32)));
using RowBits = int64_t __attribute__((vector_size(32)));
using Floats = float __attribute__((vector_size(16)));

// Points of the three-dimensional slice.
struct alignas(32) JuliaLanes {
  static constexpr int kCount = 8;

  double x[kCount], y[kCount], z[kCount];

  void set(int lane, const Vec3& p) {
    x[lane] = p.x;
    y[lane] = p.y;
    z[lane] = p.z;
  }
};
constexpr int kRows = JuliaLanes::kCount / 4;
constexpr unsigned kAllLanes = (1u << JuliaLanes::kCount) - 1;

struct Rows {
  Row x, y, z, w;
};

DURER_INLINE void start(const JuliaSlice& slice, const JuliaLanes& lanes, Rows (&z)[kRows]) {
  const Vec4& n = slice.normal;
  for (int r = 0; r < kRows; ++r) {
    const Row &px = reinterpret_cast<const Row*>(lanes.x)[r],
              &py = reinterpret_cast<const Row*>(lanes.y)[r],
              &pz = reinterpret_cast<const Row*>(lanes.z)[r];
    z[r] = {px, py, pz, (slice.distance - n.x * px - n.y * py - n.z * pz) / n.w};
  }
}

DURER_INLINE unsigned signs_of(const Row& row) {
  return static_cast<unsigned>(_mm_movemask_pd(__builtin_shufflevector(row, row, 0, 1)) |
                               _mm_movemask_pd(__builtin_shufflevector(row, row, 2, 3)) << 2);
}

// A bit for each point: whether it is in the set.
template <typename Map>
DURER_INLINE unsigned lanes_in_set(const Map& map, const JuliaSlice& slice,
                                   const JuliaLanes& lanes) {
  Rows z[kRows];
  start(slice, lanes, z);
  unsigned in_set = kAllLanes;
  for (int i = 0; i < slice.iterations; ++i) {
    for (int r = 0; r < kRows; ++r) {
      const QuaternionSquares squares(z[r]);
      const RowBits gone = squares.sum() > slice.escape2;
      in_set &= ~(signs_of((Row)gone) << 4 * r);
      z[r] = map.image(z[r], squares);
    }
    if (!in_set) break;
  }
  return in_set;
}

// Whether all points in a ball around each, of that radius in the fourfold space, are known to be in the
// set, however orbits round; for the lanes from the first one on until it is not known.
template <typename Map>
DURER_INLINE unsigned balls_in_set(const Map& map, const JuliaSlice& slice, const JuliaLanes& lanes,
                                   double radius) {
  // More than the rounding of a step, in double precision for orbits of quaternions smaller than 2 and in
  // single precision for the bounds of their sizes.
  constexpr float kRounding = 1e-13f, kWiden = 1 + 1e-6f;
  const float first = static_cast<float>(radius) * kWiden + kRounding;
  const float limit = static_cast<float>(std::sqrt(slice.escape2)) * (1 - 1e-5f);
  Rows z[kRows];
  start(slice, lanes, z);
  Floats apart[kRows];
  for (Floats& a : apart) a = Floats{first, first, first, first};
  unsigned held = kAllLanes;
  for (int i = 0; i < slice.iterations; ++i) {
    for (int r = 0; r < kRows; ++r) {
      const QuaternionSquares squares(z[r]);
      const Floats size = _mm_sqrt_ps(__builtin_convertvector(squares.sum(), Floats));
      const auto is_held = size + apart[r] <= limit;
      held &= ~(0xfu << 4 * r) | static_cast<unsigned>(_mm_movemask_ps((Floats)is_held))
                                     << 4 * r;
      apart[r] = Map::spread(size, apart[r]) * kWiden + kRounding;
      z[r] = map.image(z[r], squares);
    }
    if (!(held & 1)) break;
  }
  return held;
}

}  // namespace durer
