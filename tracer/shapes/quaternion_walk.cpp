// Rows are never passed: what takes them is built in.
#pragma GCC diagnostic ignored "-Wpsabi"
#include "tracer/shapes/quaternion_walk.h"

#include <algorithm>

#include "tracer/math/kernel.h"

namespace durer {
namespace {

// A quaternion as one number of the processor's.
using Row = double __attribute__((vector_size(32)));
using RowBits = int64_t __attribute__((vector_size(32)));

constexpr RowBits kFirstSign = {INT64_MIN, 0, 0, 0};

// quaternion_product(), its sums in the same order.
DURER_INLINE Row product(const Row& a, const Row& b) {
  const Row second = __builtin_shufflevector(a, a, 1, 1, 2, 3) *
                     __builtin_shufflevector(b, b, 1, 0, 0, 0);
  const Row third = __builtin_shufflevector(a, a, 2, 2, 3, 1) *
                    __builtin_shufflevector(b, b, 2, 3, 1, 2);
  const Row fourth = __builtin_shufflevector(a, a, 3, 3, 1, 2) *
                     __builtin_shufflevector(b, b, 3, 2, 3, 1);
  return a[0] * b + (Row)((RowBits)second ^ kFirstSign) + (Row)((RowBits)third ^ kFirstSign) -
         fourth;
}

template <typename Map>
DURER_INLINE bool look(const Map& map, const JuliaSlice& slice, const Vec3& point,
                       double& distance) {
  Vec4 z = slice.start(point);
  Row q = {z.x, z.y, z.z, z.w};  // the product of all points of the orbit
  QuaternionSquares squares(z);
  double shrink = 1 / Map::kDegree;
  for (int left = slice.iterations;; --left) {
    if (left <= 0) return true;
    if (squares.sum() > slice.escape2) break;
    z = map.image(z, squares);
    squares = QuaternionSquares(z);
    q = product(Row{z.x, z.y, z.z, z.w}, q);
    shrink /= Map::kDegree;
  }
  const Row q2 = q * q;
  const double size2 = squares.sum();
  distance = shrink * std::sqrt(size2 / (q2[0] + q2[1] + q2[2] + q2[3])) * std::log(size2);
  return false;
}

template <typename Map>
DURER_INLINE bool approach(const Map& map, const JuliaSlice& slice, const QuaternionWalk& walk) {
  Vec3 point = walk.point;
  double t = walk.t, distance = walk.distance;
  for (;;) {
    const double step = std::max(distance, walk.precision);
    const double next_t = t + step;
    if (!(next_t < walk.end)) return false;
    const Vec3 next = point + step * walk.direction;
    if (look(map, slice, next, distance)) break;
    point = next;
    t = next_t;
  }
  walk.point = point;
  walk.t = t;
  walk.distance = distance;
  return true;
}

}  // namespace

DURER_KERNEL bool look_for_set(const QuaternionSquare& map, const JuliaSlice& slice,
                               const Vec3& point, double& distance) {
  return look(map, slice, point, distance);
}
DURER_KERNEL bool look_for_set(const QuaternionCube& map, const JuliaSlice& slice,
                               const Vec3& point, double& distance) {
  return look(map, slice, point, distance);
}

DURER_KERNEL bool approach_set(const QuaternionSquare& map, const JuliaSlice& slice,
                               const QuaternionWalk& walk) {
  return approach(map, slice, walk);
}
DURER_KERNEL bool approach_set(const QuaternionCube& map, const JuliaSlice& slice,
                               const QuaternionWalk& walk) {
  return approach(map, slice, walk);
}

}  // namespace durer
