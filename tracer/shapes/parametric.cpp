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
};

class Parametric final : public Shape {
 public:
  explicit Parametric(const ParametricNode& node) : node_(node), container_(node.container) {}

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
    stack.push_back({node_.u_range.x, node_.u_range.y, node_.v_range.x, node_.v_range.y});
    while (!stack.empty()) {
      const Rectangle r = stack.back();
      stack.pop_back();
      double depth = 0, longest = 0;
      if (!may_be_hit(ray, r, from, to, best, depth, longest)) continue;
      const double du = r.u1 - r.u0, dv = r.v1 - r.v0;
      if (std::min(std::max(du, dv), longest) < node_.accuracy) {
        if (depth < best && depth > from) {
          best = depth;
          found = {r.u0, r.v0};
        }
        continue;
      }
      // The lower half is searched first.
      if (du >= dv) {
        const double middle = 0.5 * (r.u0 + r.u1);
        stack.push_back({middle, r.u1, r.v0, r.v1});
        stack.push_back({r.u0, middle, r.v0, r.v1});
      } else {
        const double middle = 0.5 * (r.v0 + r.v1);
        stack.push_back({r.u0, r.u1, middle, r.v1});
        stack.push_back({r.u0, r.u1, r.v0, middle});
      }
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

  Interval bounds_of(int axis, const Rectangle& r) const {
    const double a = node_.accuracy, g = node_.max_gradient;
    const double f00 = coordinate(axis, r.u0, r.v0) - a, f01 = coordinate(axis, r.u0, r.v1) - a;
    const double f10 = coordinate(axis, r.u1, r.v0) - a, f11 = coordinate(axis, r.u1, r.v1) - a;
    const Interval left = enclose(g, r.v1 - r.v0, f00, f01), right = enclose(g, r.v1 - r.v0, f10, f11);
    return {enclose(g, r.u1 - r.u0, left.low, right.low).low,
            enclose(g, r.u1 - r.u0, left.high, right.high).high};
  }

  // depth: where the ray enters the bounds of the last axis that it is not parallel to.
  bool may_be_hit(const ShapeRay& ray, const Rectangle& r, double from, double to, double best,
                  double& depth, double& longest) const {
    Interval earlier[3];
    int count = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Interval range = bounds_of(axis, r);
      const double o = ray.origin[axis], d = ray.direction[axis];
      if (std::abs(d) < kGeometryEpsilon) {
        if (o < range.low || o > range.high) return false;
        continue;
      }
      double t0 = (range.low - o) / d, t1 = (range.high - o) / d;
      if (t0 > t1) std::swap(t0, t1);
      if (t0 > to || t1 < from || t0 > best) return false;
      for (int i = 0; i < count; ++i)
        if (t0 > earlier[i].high || t1 < earlier[i].low) return false;
      earlier[count++] = {t0, t1};
      depth = t0;
      longest = std::max(longest, t1 - t0);
    }
    return true;
  }

  ParametricNode node_;
  Container container_;
};

}  // namespace

PlacedShape compile(const ParametricNode& node, const ShapeContext&) {
  return {std::make_shared<Parametric>(node), false, {}};
}

}  // namespace durer
