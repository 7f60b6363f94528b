// parametric { function, function, function <u,v>, <u,v> … }             (spec/functions.md 8)
#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "tracer/scene/function.h"
#include "tracer/shapes/container.h"
#include "tracer/shapes/parametric_bounds.h"

namespace durer {
namespace {

struct Interval {
  double low, high;
};

struct Rectangle : ParameterRectangle {
  Corners corner[3];  // not known of coordinates whose bounds are precomputed
  uint32_t number;    // among the precomputed ones
  double depth;       // where the ray enters the bounds of the last axis it is not parallel to
  double greatest;    // of all such axes
  double longest;     // way through the bounds of one axis
};

class Parametric final : public Shape {
 public:
  explicit Parametric(const ParametricNode& node) : node_(node), container_(node.container) {
    root_ = {node.u_range.x, node.u_range.y, node.v_range.x, node.v_range.y};
    for (size_t axis = 0; axis < 3; ++axis) {
      coordinate_[axis] = {node.function[axis]->compiled.get(), node.accuracy, node.max_gradient};
      root_corner_[axis] = coordinate_[axis].corners(root_);
      if (!node.precompute[axis]) continue;
      // Half the accuracy: sides of one level may differ in their last digits.
      precomputed_[axis] = {coordinate_[axis], root_, node.precompute_depth, 0.5 * node.accuracy};
      precomputed_count_ = precomputed_[axis].count();
    }
  }

  Bounds bounds() const override { return container_.bounds(); }
  bool is_patch() const override { return true; }
  bool inside(const Vec3&) const override { return false; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    BoxCrossing crossing;
    if (!container_.cross(ray, crossing)) return;
    double from = crossing.near;
    const double to = crossing.far;
    if (from == to) from = 0;
    from += 4 * node_.accuracy;
    if (from > to) return;

    double best = to;
    Vec2 found(0);
    thread_local std::vector<Rectangle> stack;
    stack.clear();
    Rectangle root{root_, {root_corner_[0], root_corner_[1], root_corner_[2]}, 1, 0, 0, 0};
    bool met = true;
    Crossings root_crossings;
    for (int axis = 0; axis < 3 && met; ++axis) {
      const CoordinateRange range = is_precomputed(axis, 1)
                                 ? precomputed_[axis][1]
                                 : coordinate_[axis].estimate(root, root.corner[axis]);
      met = may_be_hit(ray, axis, range, root, from, to, best, root_crossings);
    }
    if (met) stack.push_back(root);
    while (!stack.empty()) {
      const Rectangle r = stack.back();
      stack.pop_back();
      if (r.greatest > best) continue;
      const double du = r.u1 - r.u0, dv = r.v1 - r.v0;
      const bool along_u = r.splits_u();
      const double middle = r.middle();
      // An accuracy of 0 ends where no number lies between two others.
      const bool is_least = along_u ? !(r.u0 < middle && middle < r.u1)
                                    : !(r.v0 < middle && middle < r.v1);
      if (std::min(std::max(du, dv), r.longest) < node_.accuracy || is_least) {
        if (r.depth < best && r.depth > from) {
          best = r.depth;
          found = {r.u0, r.v0};
        }
        continue;
      }
      split(ray, r, from, to, best, stack);
    }
    if (best < to)
      out.push(best, 0, static_cast<float>(found.x), static_cast<float>(found.y));
  }

  Vec3 normal(const Vec3&, const ShapeHit& hit) const override {
    const double u = static_cast<double>(hit.u), v = static_cast<double>(hit.v);
    const double step = node_.accuracy;
    const Vec3 at = point(u, v);
    return cross(point(u + step, v) - at, point(u, v + step) - at);
  }
  Vec2 uv(const Vec3&, const Vec3&, const ShapeHit& hit) const override {
    return {static_cast<double>(hit.u), static_cast<double>(hit.v)};
  }

 private:
  Vec3 point(double u, double v) const {
    return {coordinate_[0](u, v), coordinate_[1](u, v), coordinate_[2](u, v)};
  }

  // The t-intervals of the axes seen so far.
  struct Crossings {
    Interval interval[3];
    int count = 0;
  };

  bool is_precomputed(int axis, uint32_t number) const {
    return number < precomputed_count_ && !precomputed_[axis].empty();
  }

  // A half that one axis rules out asks no other.
  void split(const ShapeRay& ray, const Rectangle& r, double from, double to, double best,
             std::vector<Rectangle>& stack) const {
    Rectangle low = r, high = r;
    const double middle = r.middle();
    (r.splits_u() ? low.u1 : low.v1) = middle;
    (r.splits_u() ? high.u0 : high.v0) = middle;
    low.depth = low.greatest = low.longest = high.depth = high.greatest = high.longest = 0;
    // Those below the precomputed ones share a number that is none of theirs.
    low.number = std::min(2 * r.number, precomputed_count_);
    high.number = std::min(2 * r.number + 1, precomputed_count_);
    Crossings low_crossings, high_crossings;
    bool low_met = true, high_met = true;
    for (int axis = 0; axis < 3; ++axis) {
      CoordinateRange low_range, high_range;
      if (is_precomputed(axis, low.number)) {
        low_range = precomputed_[axis][low.number];
        high_range = precomputed_[axis][high.number];
      } else {
        const ParametricCoordinate& f = coordinate_[axis];
        const Corners whole = is_precomputed(axis, r.number) ? f.corners(r) : r.corner[axis];
        std::tie(low.corner[axis], high.corner[axis]) = f.halves(r, whole);
        low_range = f.estimate(low, low.corner[axis]);
        high_range = f.estimate(high, high.corner[axis]);
      }
      low_met = low_met && may_be_hit(ray, axis, low_range, low, from, to, best, low_crossings);
      high_met = high_met && may_be_hit(ray, axis, high_range, high, from, to, best, high_crossings);
      if (!low_met && !high_met) return;
    }
    // The lower half is searched first.
    if (high_met) stack.push_back(high);
    if (low_met) stack.push_back(low);
  }

  // One axis after the other, x first.
  bool may_be_hit(const ShapeRay& ray, int axis, const CoordinateRange& range, Rectangle& r, double from,
                  double to, double best, Crossings& crossings) const {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (std::abs(d) < kGeometryEpsilon) return o >= range.low && o <= range.high;
    double t0 = (range.low - o) / d, t1 = (range.high - o) / d;
    if (!(t0 <= t1)) std::swap(t0, t1);  // also where either is no number, as in povray
    if (t0 > to || t1 < from || t0 > best) return false;
    for (int i = 0; i < crossings.count; ++i)
      if (t0 > crossings.interval[i].high || t1 < crossings.interval[i].low) return false;
    crossings.interval[crossings.count++] = {t0, t1};
    r.depth = t0;
    r.greatest = crossings.count == 1 ? t0 : std::max(r.greatest, t0);
    r.longest = std::max(r.longest, t1 - t0);
    return true;
  }

  ParameterRectangle root_;
  Corners root_corner_[3];
  ParametricCoordinate coordinate_[3];
  PrecomputedBounds precomputed_[3];
  uint32_t precomputed_count_ = 0;
  ParametricNode node_;
  Container container_;
};

}  // namespace

PlacedShape compile(const ParametricNode& node, const ShapeContext&) {
  return {std::make_shared<Parametric>(node), false, {}};
}

}  // namespace durer
