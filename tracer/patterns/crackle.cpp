// crackle: distances to the nearest of random points, one in each lattice cell.
//
//   crackle   form V (<-1,1,0>), metric F (2), offset F (0), solid
//
//   pigment { crackle form <1,0,0> color_map { [0 rgb 0] [1 rgb 1] } }
//
// Source: spec/textures.md 6.4.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "tracer/math/lattice_hash.h"
#include "tracer/math/power.h"
#include "tracer/patterns/crackle_features.h"
#include "tracer/patterns/noise.h"
#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

// The 81 cells that can hold one of the nearest points, as steps away from the cell of the point;
// a positive step goes to the side on which the point lies. Near ones first.
struct CellStep {
  int8_t x, y, z;
};
constexpr int kCells = 81;
// Sixteenths of the squared gap between a step's cell and a point a quarter off the middle; steps of
// two come after all others.
constexpr int typical_gap(int step) {
  switch (step) {
    case 0: return 0;
    case 1: return 1;
    case -1: return 9;
    case 2: return 28;
    default: return 49;
  }
}
constexpr std::array<CellStep, kCells> kSteps = [] {
  std::array<CellStep, kCells> steps{};
  size_t count = 0;
  for (int gap = 0; gap <= 3 * 49; ++gap) {
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          const int far = (x * x == 4) + (y * y == 4) + (z * z == 4);
          if (far <= 1 && typical_gap(x) + typical_gap(y) + typical_gap(z) == gap)
            steps[count++] = {static_cast<int8_t>(x), static_cast<int8_t>(y),
                              static_cast<int8_t>(z)};
        }
      }
    }
  }
  return steps;
}();
// From here on a cell lies two steps away along some axis: a whole unit or more.
constexpr int kAdjacentCells = 27;
static_assert([] {
  for (int i = 0; i < kCells; ++i) {
    const CellStep& s = kSteps[static_cast<size_t>(i)];
    const bool adjacent = s.x * s.x <= 1 && s.y * s.y <= 1 && s.z * s.z <= 1;
    if (adjacent != (i < kAdjacentCells)) return false;
  }
  return true;
}());

class Crackle : public BasePattern {
 public:
  Crackle(const PatternNode& node, const PatternSettings& settings)
      : parameters_(node.crackle),
        generator_(noise_generator_of(node, settings)),
        random_(pattern_random_table().data()),
        can_skip_(node.crackle.metric > 0),
        needed_(parameters_.solid ? 0 : parameters_.form.z != 0 ? 2 : parameters_.form.y != 0 ? 1 : 0) {}

  double base_value(const Vec3& p, const PatternContext&) const override {
    const Vec3 cell = glm::floor(p - Vec3(kEpsilon));
    double nearest[3] = {1e300, 1e300, 1e300};
    Vec3 nearest_point(0);
    if (parameters_.metric == 2) {
      const AdjacentFeatures& adjacent = features_around(cell);
      find_nearest(adjacent, p, nearest);
      if (parameters_.solid) nearest_point = feature_at(adjacent, p, nearest[0]);
      if (nearest[needed_] > 1 - 1e-9) look_in_cells(kAdjacentCells, p, cell, nearest, nearest_point);
    } else {
      look_in_cells(0, p, cell, nearest, nearest_point);
    }
    if (parameters_.solid) return std::clamp(noise(nearest_point, generator_), 0.0, 1.0);
    double value = 0;
    for (int i = 0; i <= needed_; ++i) value += parameters_.form[i] * root(nearest[i]);
    return std::clamp(value, 0.0, 1.0);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  // In those of kSteps from the `first` on.
  void look_in_cells(int first, const Vec3& p, const Vec3& cell, double (&nearest)[3],
                     Vec3& nearest_point) const {
    // Along each axis: the way to the point's side, and how far the cell of a step is away there.
    double gap[3][5];
    int side[3] = {}, place[3] = {};
    for (int axis = 0; axis < 3; ++axis) {
      place[axis] = static_cast<int>(static_cast<int64_t>(cell[axis]) & 4095);
      const double inside = p[axis] - cell[axis];
      side[axis] = inside >= 0.5 ? 1 : -1;
      const double to_side = inside >= 0.5 ? 1 - inside : inside;
      gap[axis][0] = part(2 - to_side);
      gap[axis][1] = part(1 - to_side);
      gap[axis][2] = 0;
      gap[axis][3] = part(to_side);
      gap[axis][4] = part(1 + to_side);
    }
    for (int i = first; i < kCells; ++i) {
      const CellStep& step = kSteps[static_cast<size_t>(i)];
      // A cell that lies further off than the last point that counts cannot change the answer.
      if (can_skip_) {
        const double limit = nearest[needed_];
        if (i == kAdjacentCells && limit <= 1 - 1e-9) break;
        const double least = gap[0][step.x + 2] + gap[1][step.y + 2] + gap[2][step.z + 2];
        if (least * (1 - 1e-12) >= limit) continue;
      }
      const int dx = step.x * side[0], dy = step.y * side[1], dz = step.z * side[2];
      const int q = hash_cell(place[0] + dx, place[1] + dy, place[2] + dz);
      const Vec3 candidate = cell + Vec3(dx, dy, dz);
      const Vec3 feature = candidate + Vec3(random_[q], random_[q + 1], random_[q + 2]);
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
  }

  // One axis' share of the measure.
  double part(double d) const {
    if (parameters_.metric == 2) return d * d;
    return parameters_.metric == 1 ? std::abs(d) : power(std::abs(d), parameters_.metric);
  }
  double measure(const Vec3& d) const {
    if (parameters_.metric == 2) return dot(d, d);
    if (parameters_.metric == 1) return std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    return power(std::abs(d.x), parameters_.metric) +
           power(std::abs(d.y), parameters_.metric) +
           power(std::abs(d.z), parameters_.metric);
  }
  double root(double sum) const {
    if (parameters_.offset != 0) sum += power(parameters_.offset, parameters_.metric);
    if (parameters_.metric == 2) return std::sqrt(sum);
    return parameters_.metric == 1 ? sum : power(sum, 1 / parameters_.metric);
  }

  CrackleParameters parameters_;
  int generator_;
  const double* random_;  // pattern_random_table()
  bool can_skip_;  // distance grows with each component
  int needed_;     // the last of the nearest points, from 0, that matters
};

}  // namespace

std::unique_ptr<const BasePattern> make_crackle(const PatternNode& n, const PatternSettings& s) {
  return std::make_unique<Crackle>(n, s);
}

}  // namespace durer
