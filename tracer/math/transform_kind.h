// What a transform does, told from its matrix: several shapes take simple transforms into their own
// numbers and keep only the others beside them (spec/geometry.md 3).
#pragma once

#include "tracer/math/transform.h"

namespace durer {

enum class TransformKind : unsigned char { translation, scaling, rotation, general };

// `scaling` is a diagonal matrix and `rotation` an orthonormal one, both without translation.
TransformKind kind_of(const Transform& transform);

}  // namespace durer
