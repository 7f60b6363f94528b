// Our own bounding volume hierarchy, eight boxes to a node (performance.md 2, 3): for worlds with up
// to some thousand items, inside composites and for meshes. Boxes are in single precision, rounded
// outward; what lies in them is tested by the caller in double, so nothing here decides a hit.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "tracer/math/bounds.h"
#include "tracer/math/min_max.h"
#include "tracer/math/ray.h"
#include "tracer/shapes/shape_ray.h"

namespace durer {

struct alignas(64) BvhNode {
  static constexpr uint32_t kLeaf = 0x80000000u;

  float low[3][8];
  float high[3][8];
  // Inner: index of a node. Leaf: kLeaf | first item << 3 | count - 1.
  uint32_t child[8];
  uint32_t used;  // bit i: slot i holds a box
};

// A ray with what its walks share. Shapes that are not moved take it as it is.
struct BvhRay : ShapeRay {
  BvhRay(const Vec3& from, const Vec3& along) : ShapeRay{from, along}, inverse(1.0 / along) {
    for (int axis = 0; axis < 3; ++axis) {
      is_down[axis] = static_cast<uint32_t>(std::bit_cast<uint64_t>(inverse[axis]) >> 63);
    }
  }

  // Narrows the interval [low, high] to the ray's way through a box, perhaps to an empty one.
  [[gnu::always_inline]] void clip(const Bounds& box, double& low, double& high) const {
    const double* plane = &box.min.x;
    for (uint32_t axis = 0; axis < 3; ++axis) {
      // NaN (0·∞ in a face's plane) does not narrow the interval. Which face is nearer is looked up
      // by number: processors cannot guess it.
      const uint32_t down = 3 * is_down[axis];
      const double near = (plane[axis + down] - origin[axis]) * inverse[axis];
      const double far = (plane[axis + 3 - down] - origin[axis]) * inverse[axis];
      low = larger_of(near, low);
      high = smaller_of(far, high);
    }
  }

  Vec3 inverse;         // 1/direction, infinite where a component is 0
  uint32_t is_down[3];  // 1 where the ray goes down an axis
};
static_assert(offsetof(Bounds, max) == sizeof(Vec3));

struct BvhBeam;
struct BvhWalk;

class Bvh {
 public:
  // Boxes must be finite and not empty; item i is boxes[i].
  void build(const std::vector<Bounds>& boxes);
  // The same of boxes that are made when they are asked for, once each; `bounds` encloses them all.
  void build(size_t count, const Bounds& bounds, const std::function<Bounds(uint32_t)>& box_of);

  // Visits the leaves whose boxes the ray may meet before t_max, near ones first; each item at least
  // when its box overlaps [0, t_max], perhaps also others. Origins may be anywhere.
  // bool visit(uint32_t first, uint32_t count, double& t_max) tests one leaf's items, `count`
  // positions from `first` on in items(); it may lower t_max and returns true to end the walk.
  // Defined in bvh_walk.h.
  template <bool kAnyOrder = false, typename Visitor>
  void visit_ray(const BvhRay& ray, double t_max, Visitor&& visit) const;
  // Walks once for all rays of a bundle; t_max as below. False: nothing would be gained.
  bool make_beam(const Ray* rays, int count, double t_max, BvhBeam& beam) const;
  // visit_ray() for one of these rays.
  template <typename Visitor>
  void visit_beam_ray(const BvhBeam& beam, const BvhRay& ray, double t_max, Visitor&& visit) const;
  // Visits the items whose boxes contain the point, perhaps also others.
  // bool visit(uint32_t position): one item's position in items(); true ends the walk.
  template <typename Visitor>
  void visit_point(const Vec3& point, Visitor&& visit) const;

  // Item numbers in the order of the leaves.
  const std::vector<uint32_t>& items() const { return items_; }
  bool is_empty() const { return nodes_.empty(); }
  const Bounds& bounds() const { return bounds_; }
  size_t memory() const { return nodes_.size() * sizeof(BvhNode) + items_.size() * 4; }

 private:
  bool start_walk(const BvhRay& ray, double t_max, BvhWalk& walk) const;

  std::vector<BvhNode> nodes_;   // root first
  std::vector<uint32_t> items_;  // in leaf order
  Bounds bounds_;
  Bounds reach_;  // bounds_ with the margin that rounding asks for
  // Boxes are stored relative to this point, so that far-off small scenes keep their digits.
  Vec3 center_{0};
};

}  // namespace durer
