// cells, crackle: random figures of lattice cells.
//
//   crackle   form V (<-1,1,0>), metric F (2), offset F (0), solid
//
//   pigment { crackle form <1,0,0> color_map { [0 rgb 0] [1 rgb 1] } }
//
// Source: spec/textures.md 6, 6.4.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "tracer/math/lattice_hash.h"
#include "tracer/patterns/noise.h"
#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

class Cells : public BasePattern {
 public:
  double base_value(const Vec3& p, const PatternContext&) const override {
    return std::min(1.0, random_vector_of_cell(glm::floor(p + Vec3(kEpsilon))).x);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }
};

// The 81 cells that can hold one of the nearest points, near ones first.
struct CellOffset {
  int8_t x, y, z;
};
constexpr std::array<CellOffset, 81> kOffsets = [] {
  std::array<CellOffset, 81> offsets{};
  size_t count = 0;
  for (int ring = 0; ring <= 6; ++ring) {
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          const int squared = x * x + y * y + z * z;
          const int far = (x * x == 4) + (y * y == 4) + (z * z == 4);
          if (squared == ring && far <= 1)
            offsets[count++] = {static_cast<int8_t>(x), static_cast<int8_t>(y),
                                static_cast<int8_t>(z)};
        }
      }
    }
  }
  return offsets;
}();

class Crackle : public BasePattern {
 public:
  Crackle(const PatternNode& node, const PatternSettings& settings)
      : parameters_(node.crackle),
        generator_(node.noise_generator ? node.noise_generator : settings.noise_generator),
        can_skip_(node.crackle.metric > 0) {}

  double base_value(const Vec3& p, const PatternContext&) const override {
    const Vec3 cell = glm::floor(p - Vec3(kEpsilon));
    const Vec3 inside = p - cell;
    double nearest[3] = {1e300, 1e300, 1e300};
    Vec3 nearest_point(0);
    for (const CellOffset& offset : kOffsets) {
      const Vec3 step(offset.x, offset.y, offset.z);
      // A cell that lies further off than the third nearest point cannot change the answer.
      if (can_skip_) {
        const Vec3 gap = glm::max(Vec3(0), glm::max(step - inside, inside - step - Vec3(1)));
        if (measure(gap) * (1 - 1e-12) >= nearest[2]) continue;
      }
      const Vec3 candidate = cell + step;
      const Vec3 feature = candidate + random_vector_of_cell(candidate);
      const double distance = measure(feature - p);
      if (distance < nearest[0]) {
        nearest[2] = nearest[1];
        nearest[1] = nearest[0];
        nearest[0] = distance;
        nearest_point = feature;
      } else if (distance < nearest[1]) {
        nearest[2] = nearest[1];
        nearest[1] = distance;
      } else if (distance < nearest[2]) {
        nearest[2] = distance;
      }
    }
    if (parameters_.solid) return std::clamp(noise(nearest_point, generator_), 0.0, 1.0);
    double value = 0;
    for (int i = 0; i < 3; ++i) value += parameters_.form[i] * root(nearest[i]);
    return std::clamp(value, 0.0, 1.0);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  double measure(const Vec3& d) const {
    if (parameters_.metric == 2) return dot(d, d);
    if (parameters_.metric == 1) return std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    return std::pow(std::abs(d.x), parameters_.metric) +
           std::pow(std::abs(d.y), parameters_.metric) +
           std::pow(std::abs(d.z), parameters_.metric);
  }
  double root(double sum) const {
    if (parameters_.offset != 0) sum += std::pow(parameters_.offset, parameters_.metric);
    if (parameters_.metric == 2) return std::sqrt(sum);
    return parameters_.metric == 1 ? sum : std::pow(sum, 1 / parameters_.metric);
  }

  CrackleParameters parameters_;
  int generator_;
  bool can_skip_;  // distance grows with each component
};

}  // namespace

std::unique_ptr<const BasePattern> make_cells(const PatternNode&, const PatternSettings&) {
  return std::make_unique<Cells>();
}
std::unique_ptr<const BasePattern> make_crackle(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Crackle>(n, s);
}

}  // namespace durer
