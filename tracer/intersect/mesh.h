// mesh { … } and mesh2 { … }                                         (spec/geometry.md 13.5)
#pragma once

#include <memory>

#include "tracer/shapes/shape.h"

namespace durer {

// `node` must hold a MeshNode; it is kept, not copied. Small meshes go into a Bvh, large ones into
// Embree; both find candidates, the hit is computed in double.
std::shared_ptr<const Shape> compile_mesh(const std::shared_ptr<const ShapeNode>& node);

}  // namespace durer
