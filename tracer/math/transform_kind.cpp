#include "tracer/math/transform_kind.h"

#include <cmath>

namespace durer {

TransformKind kind_of(const Transform& transform) {
  const Vec3* row = transform.forward.row;
  const bool diagonal = row[0].y == 0 && row[0].z == 0 && row[1].x == 0 && row[1].z == 0 &&
                        row[2].x == 0 && row[2].y == 0;
  const bool moves = row[3] != Vec3(0);
  if (diagonal && row[0].x == 1 && row[1].y == 1 && row[2].z == 1) {
    return TransformKind::translation;
  }
  if (moves) return TransformKind::general;
  if (diagonal) return TransformKind::scaling;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      if (std::abs(dot(row[i], row[j]) - (i == j ? 1.0 : 0.0)) > 1e-12) {
        return TransformKind::general;
      }
    }
  }
  return TransformKind::rotation;
}

}  // namespace durer
