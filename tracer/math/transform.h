// Affine maps in POV-Ray's convention: row vectors, p' = p·M, so "A then B" is A·B
// (spec/language.md 22).
#pragma once

#include "tracer/math/bounds.h"
#include "tracer/math/ray.h"
#include "tracer/math/vector.h"

namespace durer {

// Rows 0..2: the linear part; row 3: the translation.
struct Matrix {
  Vec3 row[4]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};

  [[gnu::always_inline]] Vec3 point(const Vec3& p) const {
    return p.x * row[0] + p.y * row[1] + p.z * row[2] + row[3];
  }
  [[gnu::always_inline]] Vec3 direction(const Vec3& d) const {
    return d.x * row[0] + d.y * row[1] + d.z * row[2];
  }
  // v times the transposed linear part: a normal by the inverse's matrix.
  Vec3 transposed_direction(const Vec3& v) const {
    return {dot(v, row[0]), dot(v, row[1]), dot(v, row[2])};
  }
  bool operator==(const Matrix&) const = default;
};

// first, then second.
Matrix operator*(const Matrix& first, const Matrix& second);

// The statement that a transform is: several shapes take simple ones into their own numbers and
// keep the others, `matrix` and `transform` among them whatever they do, as a matrix beside them
// (spec/geometry.md 3).
enum class TransformKind : unsigned char { translation, scaling, rotation, general };

// A matrix with its inverse. The inverse of a rotation is its transpose, kept, not recomputed.
struct Transform {
  // First, and so followed by readable memory: moving a ray reads four numbers a row.
  Matrix inverse;
  Matrix forward;
  TransformKind kind = TransformKind::general;

  static Transform translation(const Vec3& by);
  // Components must be nonzero (the parser replaces zeros by 1 with a warning).
  static Transform scaling(const Vec3& by);
  // Degrees about x, then y, then z, left-handed.
  static Transform rotation(const Vec3& degrees);
  // About a unit axis by an angle in radians (spec/language.md 22.3).
  static Transform axis_rotation(const Vec3& unit_axis, double radians);
  // Takes z to the given unit axis (used by cylinders, cones, discs).
  static Transform rotation_from_z(const Vec3& unit_axis);
  // Inverse by cofactors. False when the matrix is singular (result is then left alone).
  static bool from_matrix(const Matrix& matrix, Transform& result);

  Transform inverted() const { return {forward, inverse}; }
  // This, then next.
  Transform then(const Transform& next) const;
  bool is_identity() const { return forward == Matrix{}; }

  Vec3 point(const Vec3& p) const { return forward.point(p); }
  Vec3 direction(const Vec3& d) const { return forward.direction(d); }
  Vec3 normal(const Vec3& n) const { return inverse.transposed_direction(n); }
  [[gnu::always_inline]] Vec3 inverse_point(const Vec3& p) const { return inverse.point(p); }
  [[gnu::always_inline]] Vec3 inverse_direction(const Vec3& d) const {
    return inverse.direction(d);
  }
  Vec3 inverse_normal(const Vec3& n) const { return forward.transposed_direction(n); }
  // The ray as seen from local space; the parameter is kept (the direction is not renormalised).
  Ray inverse_ray(const Ray& ray) const {
    return {inverse.point(ray.origin), inverse.direction(ray.direction)};
  }
  // Box of the transformed box; unbounded boxes stay unbounded.
  Bounds bounds(const Bounds& local) const;
};

}  // namespace durer
