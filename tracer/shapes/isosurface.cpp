// isosurface { function … }: where a function has the value threshold    (spec/functions.md 7)
#include <algorithm>
#include <cmath>

#include "tracer/functions/compiled_function.h"
#include "tracer/scene/function.h"
#include "tracer/shapes/container.h"

namespace durer {
namespace {

constexpr uint32_t kSurfacePart = 7;  // smaller ones: sides of the container

class Isosurface final : public Shape {
 public:
  explicit Isosurface(const IsosurfaceNode& node)
      : node_(node), function_(node.function->compiled.get()), container_(node.container) {}

  Bounds bounds() const override { return container_.bounds(); }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    BoxCrossing crossing;
    if (!container_.cross(ray, crossing)) return;
    double from = std::max(crossing.near, 0.0), to = crossing.far;
    Search search{ray, node_.accuracy, node_.max_gradient, length(ray.direction), 1, 0};
    const double accuracy = node_.accuracy;
    const size_t before = out.size();
    int emitted = 0;
    if (!node_.open) {
      const double at_entry = value_on(ray, from);
      if (from > accuracy) {
        // Outside: the container closes the solid where it is entered.
        if (at_entry < 0) {
          out.push(from, static_cast<uint32_t>(crossing.entry));
          emitted = 1;
          search.sign = -1;
        }
      } else {
        if (at_entry < 4 * search.gradient * accuracy) {
          from = 5 * accuracy;
          if (value_on(ray, from) < 0) search.sign = -1;
        }
        if (value_on(ray, to) < 0) out.push(to, static_cast<uint32_t>(crossing.exit));
      }
    }
    to = std::min(to, kHugeDepth);
    from = std::min(from, to);
    if (to - from < accuracy) {
      out.shrink(before);
      return;
    }
    if (from < accuracy && search.sign > 0) {
      const double v = value_on(ray, from);
      if (std::abs(v) < 4 * search.gradient * accuracy) {
        from = 5 * accuracy;
        if (value_on(ray, from) < 0) search.sign = -1;
      }
    }
    while (emitted < node_.max_trace) {
      ++emitted;
      double at_from = search.sign * value_on(ray, from);
      if (node_.open && at_from < 0) {
        search.sign = -search.sign;
        at_from = -at_from;
      }
      const double at_to = search.sign * value_on(ray, to);
      if (!find_first(search, from, at_from, to, at_to)) break;
      out.push(search.root, kSurfacePart);
      from = search.root + 5 * accuracy;
      if (to - from < accuracy) break;
      search.sign = -search.sign;
    }
  }

  bool inside(const Vec3& p) const override {
    return container_.contains(p) && !(level(p) > 0);
  }

  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override {
    Vec3 n(0);
    if (hit.part < static_cast<uint32_t>(kNoSide)) {
      n[hit.part / 2] = hit.part % 2 ? 1 : -1;
      return n;
    }
    if (container_.sphere_normal(p, n)) return n;
    const double f = function_->value(p), step = node_.accuracy;
    n = {function_->value(p + Vec3(step, 0, 0)) - f, function_->value(p + Vec3(0, step, 0)) - f,
         function_->value(p + Vec3(0, 0, step)) - f};
    return n == Vec3(0) ? Vec3(1, 0, 0) : unit_or_zero(n);
  }

 private:
  struct Search {
    const ShapeRay& ray;
    double accuracy;
    double gradient;         // bound of |grad f|, raised by `evaluate`
    double direction_length;
    double sign;
    double root;
  };

  double level(const Vec3& p) const { return function_->value(p) - node_.threshold; }
  double value_on(const ShapeRay& ray, double t) const {
    return level(ray.origin + t * ray.direction);
  }

  bool find_first(Search& search, double from, double f_from, double to, double f_to) const {
    if (node_.evaluate && search.gradient > node_.evaluate_parameters.x)
      search.gradient *= node_.evaluate_parameters.z;
    const double width = to - from;
    return bisect(search, from, f_from, to, f_to, width,
                  search.gradient * search.direction_length * width);
  }

  // reach: the most that the function can change over the interval.
  bool bisect(Search& search, double from, double f_from, double to, double f_to, double width,
              double reach) const {
    if (node_.evaluate) {
      const double slope = std::abs(f_to - f_from) / (search.direction_length * width);
      const double growth = node_.evaluate_parameters.y;
      if (search.gradient < growth * slope) {
        search.gradient = growth * growth * slope;
        reach = search.gradient * search.direction_length * width;
      }
    }
    if (width < search.accuracy) {
      search.root = to;
      return f_to < 0;
    }
    if (!(f_from + f_to - reach < 0)) return false;
    width *= 0.5;
    reach *= 0.5;
    const double middle = from + width;
    const double f_middle = search.sign * value_on(search.ray, middle);
    return bisect(search, from, f_from, middle, f_middle, width, reach) ||
           bisect(search, middle, f_middle, to, f_to, width, reach);
  }

  IsosurfaceNode node_;
  const CompiledFunction* function_;
  Container container_;
};

}  // namespace

PlacedShape compile(const IsosurfaceNode& node, const ShapeContext&) {
  return {std::make_shared<Isosurface>(node), false, {}};
}

}  // namespace durer
