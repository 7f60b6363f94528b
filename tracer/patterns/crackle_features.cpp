#include "tracer/patterns/crackle_features.h"

#include <cstdint>

#include "tracer/math/kernel.h"
#include "tracer/math/lattice_hash.h"
#include "tracer/patterns/noise.h"

namespace durer {
namespace {

using Row = double __attribute__((vector_size(32), may_alias));
using Places = int64_t __attribute__((vector_size(32)));

constexpr double kFarOff = 1e150;

// What a thread has asked for last, by place in the lattice.
struct KnownFeatures {
  static constexpr int kSlots = 16;

  bool is_known[kSlots];
  AdjacentFeatures of[kSlots];
};
constinit thread_local KnownFeatures known{};

void fill(const Vec3& cell, const int (&place)[3], AdjacentFeatures& out) {
  const double* const random = pattern_random_table().data();
  out.cell = cell;
  int count = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const int q = hash_cell(place[0] + x, place[1] + y, place[2] + z);
        const Vec3 feature =
            cell + Vec3(x, y, z) + Vec3(random[q], random[q + 1], random[q + 2]);
        out.x[count] = feature.x;
        out.y[count] = feature.y;
        out.z[count++] = feature.z;
      }
    }
  }
  out.x[count] = out.y[count] = out.z[count] = kFarOff;
}

// What is not a number goes to `high`, if it was there.
DURER_INLINE void sort(Row& low, Row& high) {
  const Row a = low, b = high;
  low = b < a ? b : a;
  high = b < a ? a : b;
}

// The three least of each lane, ascending, and one more.
struct LeastThree {
  Row row[3];

  DURER_INLINE void add(Row more) {
    sort(row[0], more);
    sort(row[1], more);
    row[2] = more < row[2] ? more : row[2];
  }
  // Each lane with those of another.
  DURER_INLINE void add_lanes(const Places& lanes) {
    const Row other[3] = {__builtin_shuffle(row[0], lanes), __builtin_shuffle(row[1], lanes),
                          __builtin_shuffle(row[2], lanes)};
    for (const Row& more : other) add(more);
  }
};

}  // namespace

const AdjacentFeatures& features_around(const Vec3& cell) {
  int place[3];
  for (int axis = 0; axis < 3; ++axis) {
    place[axis] = static_cast<int>(static_cast<int64_t>(cell[axis]) & 4095);
  }
  const int slot = (place[0] + 3 * place[1] + 5 * place[2]) % KnownFeatures::kSlots;
  AdjacentFeatures& features = known.of[slot];
  if (!known.is_known[slot] || features.cell != cell) {
    fill(cell, place, features);
    known.is_known[slot] = true;
  }
  return features;
}

DURER_KERNEL void find_nearest(const AdjacentFeatures& features, const Vec3& point,
                               double (&squares)[3]) {
  const Row most = Row{} + 1e300;
  LeastThree least{{most, most, most}};
  for (int i = 0; i < AdjacentFeatures::kCount; i += 4) {
    const Row x = reinterpret_cast<const Row&>(features.x[i]) - point.x;
    const Row y = reinterpret_cast<const Row&>(features.y[i]) - point.y;
    const Row z = reinterpret_cast<const Row&>(features.z[i]) - point.z;
    least.add(x * x + y * y + z * z);
  }
  least.add_lanes(Places{2, 3, 0, 1});
  least.add_lanes(Places{1, 0, 3, 2});
  for (int i = 0; i < 3; ++i) squares[i] = least.row[i][0];
}

Vec3 feature_at(const AdjacentFeatures& features, const Vec3& point, double square) {
  for (int i = 0; i < AdjacentFeatures::kCount; ++i) {
    const Vec3 feature(features.x[i], features.y[i], features.z[i]);
    const Vec3 way = feature - point;
    if (dot(way, way) == square) return feature;
  }
  return Vec3(0);
}

}  // namespace durer
