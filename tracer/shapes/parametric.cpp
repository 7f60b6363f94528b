// parametric { function, function, function <u,v>, <u,v> … }             (spec/functions.md 8)
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tracer/functions/compiled_function.h"
#include "tracer/scene/function.h"
#include "tracer/shapes/container.h"

namespace durer {
namespace {

struct Interval {
  double low, high;
};

// A range that encloses a function between two values, from its greatest slope.
Interval enclose(double gradient, double width, double p, double q) {
  const double overshoot = std::max(0.0, 0.5 * (gradient * width - std::abs(p - q)));
  return {std::min(p, q) - overshoot, std::max(p, q) + overshoot};
}

struct Rectangle {
  double u0, u1, v0, v1;
  double corner[3][4];  // each coordinate at (u0,v0) (u0,v1) (u1,v0) (u1,v1)
  double depth;         // where the ray enters the bounds of the last axis it is not parallel to
  double greatest;      // of all such axes
  double longest;       // way through the bounds of one axis
};

class Parametric final : public Shape {
 public:
  explicit Parametric(const ParametricNode& node) : node_(node), container_(node.container) {
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 4; ++i)
        root_corner_[axis][i] = coordinate(axis, i / 2 ? node.u_range.y : node.u_range.x,
                                           i % 2 ? node.v_range.y : node.v_range.x);
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
    Rectangle root{};
    root.u0 = node_.u_range.x, root.u1 = node_.u_range.y;
    root.v0 = node_.v_range.x, root.v1 = node_.v_range.y;
    bool met = true;
    for (int axis = 0; axis < 3; ++axis) std::copy_n(root_corner_[axis], 4, root.corner[axis]);
    Crossings root_crossings;
    for (int axis = 0; axis < 3 && met; ++axis)
      met = may_be_hit(ray, axis, root, from, to, best, root_crossings);
    if (met) stack.push_back(root);
    while (!stack.empty()) {
      const Rectangle r = stack.back();
      stack.pop_back();
      if (r.greatest > best) continue;
      const double du = r.u1 - r.u0, dv = r.v1 - r.v0;
      const bool along_u = du >= dv;
      const double middle = along_u ? 0.5 * (r.u0 + r.u1) : 0.5 * (r.v0 + r.v1);
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
      split(ray, r, along_u, middle, from, to, best, stack);
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
  double coordinate(int axis, double u, double v) const {
    return node_.function[static_cast<size_t>(axis)]->compiled->value(Vec3(u, v, 0));
  }
  Vec3 point(double u, double v) const {
    return {coordinate(0, u, v), coordinate(1, u, v), coordinate(2, u, v)};
  }

  // The t-intervals of the axes seen so far.
  struct Crossings {
    Interval interval[3];
    int count = 0;
  };

  // Halves share the corners in the middle, and a half that one axis rules out asks no other.
  void split(const ShapeRay& ray, const Rectangle& r, bool along_u, double middle, double from,
             double to, double best, std::vector<Rectangle>& stack) const {
    Rectangle low = r, high = r;
    (along_u ? low.u1 : low.v1) = middle;
    (along_u ? high.u0 : high.v0) = middle;
    low.depth = low.greatest = low.longest = high.depth = high.greatest = high.longest = 0;
    Crossings low_crossings, high_crossings;
    bool low_met = true, high_met = true;
    for (int axis = 0; axis < 3; ++axis) {
      if (along_u) {
        low.corner[axis][2] = high.corner[axis][0] = coordinate(axis, middle, r.v0);
        low.corner[axis][3] = high.corner[axis][1] = coordinate(axis, middle, r.v1);
      } else {
        low.corner[axis][1] = high.corner[axis][0] = coordinate(axis, r.u0, middle);
        low.corner[axis][3] = high.corner[axis][2] = coordinate(axis, r.u1, middle);
      }
      low_met = low_met && may_be_hit(ray, axis, low, from, to, best, low_crossings);
      high_met = high_met && may_be_hit(ray, axis, high, from, to, best, high_crossings);
      if (!low_met && !high_met) return;
    }
    // The lower half is searched first.
    if (high_met) stack.push_back(high);
    if (low_met) stack.push_back(low);
  }

  Interval bounds_of(int axis, const Rectangle& r) const {
    const double a = node_.accuracy, g = node_.max_gradient;
    const double* f = r.corner[axis];
    const Interval left = enclose(g, r.v1 - r.v0, f[0] - a, f[1] - a);
    const Interval right = enclose(g, r.v1 - r.v0, f[2] - a, f[3] - a);
    return {enclose(g, r.u1 - r.u0, left.low, right.low).low,
            enclose(g, r.u1 - r.u0, left.high, right.high).high};
  }

  // One axis after the other, x first.
  bool may_be_hit(const ShapeRay& ray, int axis, Rectangle& r, double from, double to, double best,
                  Crossings& crossings) const {
    const Interval range = bounds_of(axis, r);
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (std::abs(d) < kGeometryEpsilon) return o >= range.low && o <= range.high;
    double t0 = (range.low - o) / d, t1 = (range.high - o) / d;
    if (t0 > t1) std::swap(t0, t1);
    if (t0 > to || t1 < from || t0 > best) return false;
    for (int i = 0; i < crossings.count; ++i)
      if (t0 > crossings.interval[i].high || t1 < crossings.interval[i].low) return false;
    crossings.interval[crossings.count++] = {t0, t1};
    r.depth = t0;
    r.greatest = crossings.count == 1 ? t0 : std::max(r.greatest, t0);
    r.longest = std::max(r.longest, t1 - t0);
    return true;
  }

  double root_corner_[3][4];
  ParametricNode node_;
  Container container_;
};

}  // namespace

PlacedShape compile(const ParametricNode& node, const ShapeContext&) {
  return {std::make_shared<Parametric>(node), false, {}};
}

}  // namespace durer
