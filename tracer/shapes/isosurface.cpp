// isosurface { function … }: where a function has the value threshold    (spec/functions.md 7)
#include <algorithm>
#include <cmath>
#include <random>

#include "tracer/functions/compiled_function.h"
#include "tracer/scene/function.h"
#include "tracer/shapes/container.h"

namespace durer {
namespace {

constexpr uint32_t kSurfacePart = 7;  // smaller ones: sides of the container
// Lines that settle the gradient of `evaluate`, and how many of them in a row that do not raise it.
constexpr int kMostLines = 4096;
constexpr int kCalmLines = 512;

class Isosurface final : public Shape {
 public:
  explicit Isosurface(const IsosurfaceNode& node)
      : node_(node),
        function_(node.function->compiled.get()),
        container_(node.container),
        gradient_(node.max_gradient) {
    if (node_.evaluate) settle_gradient();
  }

  Bounds bounds() const override { return container_.bounds(); }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    Search search{ray, node_.accuracy, gradient_, length(ray.direction), 1, 0};
    find_hits(search, out);
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

  void find_hits(Search& search, HitStack& out) const {
    const ShapeRay& ray = search.ray;
    BoxCrossing crossing;
    if (!container_.cross(ray, crossing)) return;
    double from = std::max(crossing.near, 0.0), to = crossing.far;
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

  bool find_first(Search& search, double from, double f_from, double to, double f_to) const {
    if (node_.evaluate && search.gradient > node_.evaluate_parameters.x)
      search.gradient *= node_.evaluate_parameters.z;
    const double width = to - from;
    return bisect(search, from, f_from, to, f_to, width,
                  search.gradient * search.direction_length * width);
  }

  // With `evaluate`, povray keeps what a ray has raised for all rays to come, and after some rays into
  // a surface, wherever they come from, it stays nearly as it is. So as no ray depends on others, some
  // lines across the container raise it beforehand.
  void settle_gradient() {
    const Bounds box = container_.bounds();
    const Vec3 size = box.max - box.min;
    const double outside = 2 * length(size);
    std::mt19937 random;
    const auto point_in_box = [&] {
      Vec3 p = box.min;
      for (int i = 0; i < 3; ++i) p[i] += size[i] * static_cast<double>(random()) * 0x1p-32;
      return p;
    };
    HitStack hits;
    for (int line = 0, calm = 0; line < kMostLines && calm < kCalmLines; ++line, ++calm) {
      const Vec3 middle = point_in_box(), direction = unit_or_zero(point_in_box() - middle);
      const ShapeRay ray{middle - outside * direction, direction};
      Search search{ray, node_.accuracy, gradient_, 1, 1, 0};
      find_hits(search, hits);
      hits.shrink(0);
      if (search.gradient <= gradient_) continue;
      gradient_ = search.gradient;
      calm = 0;
    }
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
  double gradient_;  // where searches start
};

}  // namespace

PlacedShape compile(const IsosurfaceNode& node, const ShapeContext&) {
  return {std::make_shared<Isosurface>(node), false, {}};
}

}  // namespace durer
