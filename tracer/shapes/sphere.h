// Spheres for shapes that turn into one (ovus).
#pragma once

#include "tracer/shapes/shape.h"

namespace durer {

std::shared_ptr<const Shape> make_sphere(const Vec3& center, double radius);

}  // namespace durer
