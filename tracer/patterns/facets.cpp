// facets: normals gathered around feature points, as on a cut stone.
//
//   size F     size of a facet                                    0.1
//   coords F   0: facets of the normal; else of the place, F deep   0
//   metric V   first component: the measure of distance             2
//
//   normal { facets coords 0.5 size 0.2 }
//
// Source: spec/textures.md 14.3.
#include "tracer/patterns/facets.h"

#include <cmath>

#include "tracer/math/power.h"
#include "tracer/patterns/crackle_features.h"
#include "tracer/patterns/noise.h"
#include "tracer/patterns/pattern_factories.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

double measure(const Vec3& d, double metric) {
  if (metric == 2) return dot(d, d);
  if (metric == 1) return d.x + d.y + d.z;  // signed: POV-Ray's way
  return power(std::abs(d.x), metric) + power(std::abs(d.y), metric) +
         power(std::abs(d.z), metric);
}

// The nearest of the feature points in the 81 cells around t: those of `crackle`.
Vec3 nearest_feature(const Vec3& t, double metric) {
  const Vec3 middle = glm::floor(t - Vec3(kEpsilon));
  if (metric == 2) {
    const AdjacentFeatures& adjacent = features_around(middle);
    double squares[3];
    find_nearest(adjacent, t, squares);
    // The other cells lie a whole unit away.
    if (squares[0] <= 1 - 1e-9) return feature_at(adjacent, t, squares[0]);
  }
  Vec3 nearest(0);
  double least = 1e300;
  for (int dx = -2; dx <= 2; ++dx) {
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dz = -2; dz <= 2; ++dz) {
        if ((std::abs(dx) == 2) + (std::abs(dy) == 2) + (std::abs(dz) == 2) > 1) continue;
        const Vec3 cell = middle + Vec3(dx, dy, dz);
        // Its points lie up to a unit beyond this corner.
        if (metric == 1 && measure(cell - t, 1) >= least + 1e-9) continue;
        const Vec3 feature = cell + random_vector_of_cell(cell);
        const double distance = measure(feature - t, metric);
        if (distance < least) {
          least = distance;
          nearest = feature;
        }
      }
    }
  }
  return nearest;
}

// Only the normal is bent: as a height the pattern is flat.
class Facets : public BasePattern {
 public:
  double base_value(const Vec3&, const PatternContext&) const override { return 0; }
  ValueRange base_range(const Bounds&) const override { return {0, 0}; }
};

}  // namespace

Vec3 facets_normal(const FacetsParameters& facets, const Vec3& q, Vec3 n) {
  n = unit_or_zero(n);
  const double scale = facets.size < 1e-6 ? 1e6 : 1 / facets.size;
  const double depth = facets.coordinates_size;
  if (depth == 0) return nearest_feature(n * scale, facets.metric);
  Vec3 g = vector_noise(nearest_feature(q * scale, facets.metric));
  g -= dot(g, n) * n;
  return n + depth * g;
}

std::unique_ptr<const BasePattern> make_facets(const PatternNode&, const PatternSettings&) {
  return std::make_unique<Facets>();
}

}  // namespace durer
