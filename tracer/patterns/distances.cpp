// gradient, planar, cylindrical, spherical, boxed, onion, radial, leopard: distances and angles.
//
//   gradient V   place along V, folded above 1    (V: vector, default x)
//   planar, cylindrical, spherical, boxed   1 at the middle, 0 from distance 1 on
//   onion        distance from the origin, folded
//   radial       angle about y
//   leopard      product of sines
//
//   pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } }
//
// Source: spec/textures.md 6.
#include <algorithm>
#include <cmath>

#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

// Falls from 1 to 0 over the unit distance.
double density(double distance) {
  if (distance < 0) return 1;
  return distance > 1 ? 0 : 1 - distance;
}

class Gradient : public BasePattern {
 public:
  // Along the zero vector nothing is a number, as in POV-Ray.
  explicit Gradient(const Vec3& g) : direction_(g / length(g)) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    const double t = dot(p, direction_);
    return t > 1 ? std::fmod(t, 1.0) : t;
  }
  ValueRange base_range(const Bounds& box) const override {
    double low = 0, high = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = box.min[axis] * direction_[axis], b = box.max[axis] * direction_[axis];
      low += std::min(a, b);
      high += std::max(a, b);
    }
    low -= 1e-9 * std::abs(low);  // the sum's rounding
    high += 1e-9 * std::abs(high);
    return high <= 1 ? ValueRange{low, high} : ValueRange{std::min(low, 0.0), 1};
  }

 private:
  Vec3 direction_;
};

template <double (*Formula)(const Vec3&)>
class PointPattern : public BasePattern {
 public:
  double base_value(const Vec3& p, const PatternContext&) const override { return Formula(p); }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }
};

// Falls with the distance of each coordinate from 0.
template <double (*Formula)(const Vec3&)>
class FallingPattern : public PointPattern<Formula> {
 public:
  ValueRange base_range(const Bounds& box) const override {
    Vec3 near, far;
    for (int axis = 0; axis < 3; ++axis) {
      near[axis] = std::max({0.0, box.min[axis], -box.max[axis]});
      far[axis] = std::max(std::abs(box.min[axis]), std::abs(box.max[axis]));
    }
    return {Formula(far), Formula(near)};
  }
};

template <double (*Formula)(const Vec3&)>
class AnglePattern : public PointPattern<Formula> {
 public:
  ValueRange base_range(const Bounds&) const override { return {0.25, 1.25}; }
};

double planar(const Vec3& p) { return density(std::abs(p.y)); }
double cylindrical(const Vec3& p) { return density(std::sqrt(p.x * p.x + p.z * p.z)); }
double spherical(const Vec3& p) { return density(length(p)); }
double boxed(const Vec3& p) {
  return density(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
}
double onion(const Vec3& p) { return std::fmod(length(p), 1.0); }
double radial(const Vec3& p) {
  if (std::abs(p.x) < 0.001 && std::abs(p.z) < 0.001) return 0.25;
  return 0.25 + (std::atan2(p.x, p.z) + M_PI) / (2 * M_PI);
}
double leopard(const Vec3& p) {
  const double mean = (std::sin(p.x) + std::sin(p.y) + std::sin(p.z)) / 3;
  return mean * mean;
}

}  // namespace

std::unique_ptr<const BasePattern> make_gradient(const PatternNode& node, const PatternSettings&) {
  return std::make_unique<Gradient>(node.gradient);
}
std::unique_ptr<const BasePattern> make_planar(const PatternNode&, const PatternSettings&) {
  return std::make_unique<FallingPattern<planar>>();
}
std::unique_ptr<const BasePattern> make_cylindrical(const PatternNode&, const PatternSettings&) {
  return std::make_unique<FallingPattern<cylindrical>>();
}
std::unique_ptr<const BasePattern> make_spherical(const PatternNode&, const PatternSettings&) {
  return std::make_unique<FallingPattern<spherical>>();
}
std::unique_ptr<const BasePattern> make_boxed(const PatternNode&, const PatternSettings&) {
  return std::make_unique<FallingPattern<boxed>>();
}
std::unique_ptr<const BasePattern> make_onion(const PatternNode&, const PatternSettings&) {
  return std::make_unique<PointPattern<onion>>();
}
std::unique_ptr<const BasePattern> make_radial(const PatternNode&, const PatternSettings&) {
  return std::make_unique<AnglePattern<radial>>();
}
std::unique_ptr<const BasePattern> make_leopard(const PatternNode&, const PatternSettings&) {
  return std::make_unique<PointPattern<leopard>>();
}

}  // namespace durer
