// Rows are never passed: what takes them is built in.
#pragma GCC diagnostic ignored "-Wpsabi"
#include "tracer/shapes/quaternion_walk.h"

#include <algorithm>
#include <bit>

#include "tracer/shapes/julia_lanes.h"

namespace durer {
namespace {

constexpr int kLongestBalls = 128;  // steps that are known to be inside at once

constexpr RowBits kFirstSign = {INT64_MIN, 0, 0, 0};

// quaternion_product() of quaternions as rows, its sums in the same order.
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

template <typename Map>
DURER_INLINE bool cross(const Map& map, const JuliaSlice& slice, const QuaternionWalk& walk) {
  const Vec3 step = walk.precision * walk.direction;
  const double spacing = length(step) / std::abs(slice.normal.w);  // in the fourfold space
  Vec3 point = walk.point;
  double t = walk.t;
  JuliaLanes lanes;
  for (int stride = 2;;) {
    int passed;
    if (stride == 1) {
      Vec3 next = point;
      for (int lane = 0; lane < JuliaLanes::kCount; ++lane) {
        next += step;
        lanes.set(lane, next);
      }
      passed = std::countr_one(lanes_in_set(map, slice, lanes));
    } else {
      // Each lane for as many steps, half of them before its point, and half after.
      for (int lane = 0; lane < JuliaLanes::kCount; ++lane)
        lanes.set(lane, point + (lane * stride + 0.5 * (stride + 1)) * step);
      const double radius = (0.5 * (stride - 1) + 1e-3) * spacing;
      passed = stride * std::countr_one(balls_in_set(map, slice, lanes, radius));
    }
    for (int i = 0; i < passed; ++i) {
      t += walk.precision;
      if (!(t < walk.end)) return false;
      point += step;
    }
    if (passed == stride * JuliaLanes::kCount)
      stride = std::min(2 * stride, kLongestBalls);
    else if (stride > 1)
      stride /= 2;
    else
      break;
  }
  walk.point = point;
  walk.t = t;
  return true;
}

// Three halvings at once: all middles that they may come to, whichever sides the first ones turn out to
// be on. They are a tree: the middle after k is 2 k where the search stays, 2 k + 1 where it goes on.
template <typename Map>
DURER_INLINE JuliaPlace border(const Map& map, const JuliaSlice& slice, JuliaPlace place,
                               double step, const Vec3& direction, bool was_inside) {
  JuliaLanes lanes;
  for (;;) {
    Vec3 from[16], middle[8];
    from[1] = place.point;
    double half = step;
    for (int k = 1; k < 8; ++k) {
      if (std::has_single_bit(static_cast<unsigned>(k))) half *= 0.5;
      middle[k] = from[k] + half * direction;
      lanes.set(k, middle[k]);
      from[2 * k] = from[k];
      from[2 * k + 1] = middle[k];
    }
    lanes.set(0, middle[1]);
    const unsigned in_set = lanes_in_set(map, slice, lanes);
    for (int k = 1; k < 8;) {
      step *= 0.5;
      const bool goes_on = (in_set >> k & 1) == was_inside;
      if (goes_on) place = {middle[k], place.t + step};
      k = 2 * k + goes_on;
      // On the inner side.
      if (!(step > kLeastJuliaStep))
        return was_inside ? place : JuliaPlace{place.point + step * direction, place.t + step};
    }
  }
}

}  // namespace

// The kernels of one map.
#define DURER_WALK(Map)                                                                            \
  DURER_KERNEL bool look_for_set(const Map& map, const JuliaSlice& slice, const Vec3& point,      \
                                 double& distance) {                                              \
    return look(map, slice, point, distance);                                                     \
  }                                                                                               \
  DURER_KERNEL bool approach_set(const Map& map, const JuliaSlice& slice,                         \
                                 const QuaternionWalk& walk) {                                    \
    return approach(map, slice, walk);                                                            \
  }                                                                                               \
  DURER_KERNEL bool cross_set(const Map& map, const JuliaSlice& slice,                            \
                              const QuaternionWalk& walk) {                                       \
    return cross(map, slice, walk);                                                               \
  }                                                                                               \
  DURER_KERNEL JuliaPlace find_border(const Map& map, const JuliaSlice& slice,                    \
                                      const JuliaPlace& place, double step,                       \
                                      const Vec3& direction, bool was_inside) {                   \
    return border(map, slice, place, step, direction, was_inside);                                \
  }
DURER_WALK(QuaternionSquare)
DURER_WALK(QuaternionCube)
#undef DURER_WALK

}  // namespace durer
