// brick, hexagon, triangular: tiles of the plane and masonry.
//
//   brick A, B    brick_size V (default <8,3,4.5>), mortar F (0.5)   list of 2: mortar, brick
//   hexagon A,B,C in the xz plane, side 1                            list of 3
//   triangular A..F                                                  list of 6
//
//   pigment { brick rgb 0.5, rgb <0.6, 0.15, 0.15> }
//
// Source: spec/textures.md 6.1-6.3.
#include <cmath>
#include <cstdint>

#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

// a - trunc(a), made positive.
double fraction(double a) {
  // Sizes of 0: beyond what POV-Ray's whole numbers hold.
  if (std::isinf(a)) return a;
  const double f = a - std::trunc(a);
  return f < 0 ? f + 1 : f;
}

class Brick : public BasePattern {
 public:
  explicit Brick(const BrickParameters& brick)
      : size_(brick.size), mortar_(static_cast<float>(brick.mortar - 2 * kEpsilon)) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    const Vec3 q = p + Vec3(kEpsilon + mortar_);
    const Vec3 joint = Vec3(mortar_) / size_;
    if (fraction(q.y / size_.y) <= joint.y) return 0;
    // Every second course is shifted by half a brick, along x and along z.
    const bool lower = fraction(q.y / (2 * size_.y)) <= 0.5;
    const double x = q.x / size_.x + (lower ? 0 : 0.5);
    if (fraction(x) <= joint.x) return 0;
    const double z = q.z / size_.z + (lower ? 0.5 : 0);
    return fraction(z) <= joint.z ? 0 : 1;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  Vec3 size_;
  double mortar_;
};

class Hexagon : public BasePattern {
 public:
  double base_value(const Vec3& p, const PatternContext&) const override {
    constexpr double h = 0.866025404;
    const double x = std::abs(p.x), z = p.z;
    // The nearest of the centres (1.5 i, 2h j + (i odd ? h : 0)) in the two candidate columns.
    const int64_t column = static_cast<int64_t>(std::floor(x / 1.5));
    double best = 1e300;
    int64_t best_class = 0;
    for (int64_t i = column; i <= column + 1; ++i) {
      const double shift = (i & 1) ? h : 0;
      const int64_t j = static_cast<int64_t>(std::floor((z - shift) / (2 * h) + 0.5));
      const double dx = x - 1.5 * static_cast<double>(i);
      const double dz = z - (2 * h * static_cast<double>(j) + shift);
      const double distance = dx * dx + dz * dz;
      if (distance < best) {
        best = distance;
        best_class = j + ((i & 1) ? 2 : 0);
      }
    }
    return static_cast<double>(((best_class % 3) + 3) % 3);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 2}; }
};

class Triangular : public BasePattern {
 public:
  double base_value(const Vec3& p, const PatternContext&) const override {
    constexpr double root3 = 1.7320508075688772, h = 0.8660254037844386;
    double x = std::fmod(p.x, 3.0), z = std::fmod(p.z, root3);
    if (x < 0) x += 3;
    if (z < 0) z += root3;
    const bool upper = !(z < h);
    if (upper) z = root3 - z;
    const int a = std::min(static_cast<int>(x), 2);
    const double f = x - a;
    static constexpr int kUpright[3] = {0, 4, 2}, kLeft[3] = {1, 3, 5}, kRight[3] = {3, 5, 1};
    int tile;
    if (z < root3 * f && z < root3 * (1 - f)) {
      tile = kUpright[a];
    } else {
      tile = f < 0.5 ? kLeft[a] : kRight[a];
    }
    return upper ? 5 - tile : tile;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 5}; }
};

}  // namespace

std::unique_ptr<const BasePattern> make_brick(const PatternNode& node, const PatternSettings&) {
  return std::make_unique<Brick>(node.brick);
}
std::unique_ptr<const BasePattern> make_hexagon(const PatternNode&, const PatternSettings&) {
  return std::make_unique<Hexagon>();
}
std::unique_ptr<const BasePattern> make_triangular(const PatternNode&, const PatternSettings&) {
  return std::make_unique<Triangular>();
}

}  // namespace durer
