// density_file: the voxels of a df3 file in the unit cube.
//
//   df3 "file"       the voxels
//   interpolate N    0 none, 1 trilinear, 2 tricubic   0
//
//   density { density_file df3 "smoke.df3" interpolate 1 }
//
// Source: spec/textures.md 13.
#include "tracer/image/density_grid.h"
#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

class DensityFile : public BasePattern {
 public:
  DensityFile(const std::string& path, int interpolation)
      : grid_(path), interpolation_(interpolation) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    return grid_.value(p, interpolation_);
  }

 private:
  DensityGrid grid_;
  int interpolation_;
};

}  // namespace

std::unique_ptr<const BasePattern> make_density_file(const PatternNode& node,
                                                     const PatternSettings&) {
  // The number is taken modulo 10.
  return std::make_unique<DensityFile>(node.density_file, node.density_interpolation % 10);
}

}  // namespace durer
