// checker, square, cubic: cells of a lattice by parity or face.
//
//   checker A, B      0 or 1 by the parity of the unit cube         list of 2
//   square A, B, C, D 0..3 by the parities of x and z               list of 4
//   cubic A..F        0..5 by the face of the cube one looks through list of 6
//
//   pigment { checker rgb 1, rgb 0 }
//
// Source: spec/textures.md 6.
#include <cmath>
#include <cstdint>

#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

class Checker : public BasePattern {
 public:
  double base_value(const Vec3& p, const PatternContext&) const override {
    const double sum =
        std::floor(p.x + kEpsilon) + std::floor(p.y + kEpsilon) + std::floor(p.z + kEpsilon);
    return (static_cast<int64_t>(sum) & 1) ? 1 : 0;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }
};

class Square : public BasePattern {
 public:
  double base_value(const Vec3& p, const PatternContext&) const override {
    const bool x_odd = static_cast<int64_t>(std::floor(p.x)) & 1;
    const bool z_odd = static_cast<int64_t>(std::floor(p.z)) & 1;
    if (!x_odd) return z_odd ? 1 : 0;
    return z_odd ? 2 : 3;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 3}; }
};

class Cubic : public BasePattern {
 public:
  double base_value(const Vec3& p, const PatternContext&) const override {
    const double ax = std::abs(p.x), ay = std::abs(p.y), az = std::abs(p.z);
    if (p.x >= 0 && p.x >= ay && p.x >= az) return 0;
    if (p.y >= 0 && p.y >= ax && p.y >= az) return 1;
    if (p.z >= 0 && p.z >= ax && p.z >= ay) return 2;
    if (p.x < 0 && ax >= ay && ax >= az) return 3;
    if (p.y < 0 && ay >= ax && ay >= az) return 4;
    return 5;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 5}; }
};

}  // namespace

std::unique_ptr<const BasePattern> make_checker(const PatternNode&, const PatternSettings&) {
  return std::make_unique<Checker>();
}
std::unique_ptr<const BasePattern> make_square(const PatternNode&, const PatternSettings&) {
  return std::make_unique<Square>();
}
std::unique_ptr<const BasePattern> make_cubic(const PatternNode&, const PatternSettings&) {
  return std::make_unique<Cubic>();
}

}  // namespace durer
