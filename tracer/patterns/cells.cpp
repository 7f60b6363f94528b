// cells: a random number for each lattice cell.
//
//   pigment { cells color_map { [0 rgb 0] [1 rgb 1] } }
//
// Source: spec/textures.md 6.
#include <algorithm>

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

}  // namespace

std::unique_ptr<const BasePattern> make_cells(const PatternNode&, const PatternSettings&) {
  return std::make_unique<Cells>();
}

}  // namespace durer
