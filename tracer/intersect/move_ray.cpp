#include <cstddef>

#include "tracer/intersect/geometry.h"
#include "tracer/math/kernel.h"

namespace durer {
namespace {

// Four numbers: a row of a matrix, and one more that does not matter.
using Row = double __attribute__((vector_size(32), aligned(8), may_alias));

DURER_INLINE const Row& row_at(const Vec3& row) { return reinterpret_cast<const Row&>(row); }

}  // namespace

// What is read and written beyond a row of three is in the same struct: see Transform, and set below.
static_assert(offsetof(Transform, inverse) == 0 && sizeof(Transform) >= sizeof(Matrix) + 8);
static_assert(offsetof(ShapeRay, direction) == sizeof(Vec3) &&
              offsetof(ShapeRay, t_max) >= offsetof(ShapeRay, direction) + sizeof(Row));

DURER_KERNEL void move_ray(const Transform& transform, const BvhRay& ray, ShapeRay& local) {
  const Matrix& m = transform.inverse;
  const Vec3 &o = ray.origin, &d = ray.direction;
  const Row origin =
      o.x * row_at(m.row[0]) + o.y * row_at(m.row[1]) + o.z * row_at(m.row[2]) + row_at(m.row[3]);
  const Row direction = d.x * row_at(m.row[0]) + d.y * row_at(m.row[1]) + d.z * row_at(m.row[2]);
  reinterpret_cast<Row&>(local.origin) = origin;
  reinterpret_cast<Row&>(local.direction) = direction;
  local.unit_direction = false;
  local.csg_child = false;
}

}  // namespace durer
