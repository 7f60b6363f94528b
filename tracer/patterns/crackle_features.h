// The random points of a cell of `crackle` and the 26 around it, and which of them are nearest to a
// point (spec/textures.md 6.4).
#pragma once

#include "tracer/math/vector.h"

namespace durer {

struct AdjacentFeatures {
  static constexpr int kCount = 28;  // the last one is far off

  Vec3 cell;
  alignas(32) double x[kCount], y[kCount], z[kCount];
};

// Of the cell with this lower corner. They depend on nothing else, and rays that follow each other ask for
// the same ones: a thread keeps some. Until the next call.
const AdjacentFeatures& features_around(const Vec3& cell);
// The three least squared distances, ascending; 1e300 in place of what is not a number.
void find_nearest(const AdjacentFeatures& features, const Vec3& point, double (&squares)[3]);
// The one at this squared distance; the origin if there is none.
Vec3 feature_at(const AdjacentFeatures& features, const Vec3& point, double square);

}  // namespace durer
