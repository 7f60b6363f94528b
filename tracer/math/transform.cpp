#include "tracer/math/transform.h"

#include <cmath>

#include "tracer/math/inverse4.h"

namespace durer {

Matrix operator*(const Matrix& first, const Matrix& second) {
  Matrix product;
  for (int i = 0; i < 3; ++i) product.row[i] = second.direction(first.row[i]);
  product.row[3] = second.point(first.row[3]);
  return product;
}

Transform Transform::translation(const Vec3& by) {
  Transform t;
  t.forward.row[3] = by;
  t.inverse.row[3] = -by;
  t.kind = TransformKind::translation;
  return t;
}

Transform Transform::scaling(const Vec3& by) {
  Transform t;
  for (int i = 0; i < 3; ++i) {
    t.forward.row[i] = Vec3(0);
    t.inverse.row[i] = Vec3(0);
    t.forward.row[i][i] = by[i];
    t.inverse.row[i][i] = 1.0 / by[i];
  }
  t.kind = TransformKind::scaling;
  return t;
}

namespace {

Transform from_orthonormal(const Matrix& m) {
  Transform t;
  t.forward = m;
  for (int i = 0; i < 3; ++i) t.inverse.row[i] = {m.row[0][i], m.row[1][i], m.row[2][i]};
  return t;
}

}  // namespace

Transform Transform::rotation(const Vec3& degrees) {
  const Vec3 angle = degrees * (M_PI / 180.0);
  Matrix rx, ry, rz;
  const double cx = std::cos(angle.x), sx = std::sin(angle.x);
  const double cy = std::cos(angle.y), sy = std::sin(angle.y);
  const double cz = std::cos(angle.z), sz = std::sin(angle.z);
  rx.row[1] = {0, cx, sx};
  rx.row[2] = {0, -sx, cx};
  ry.row[0] = {cy, 0, -sy};
  ry.row[2] = {sy, 0, cy};
  rz.row[0] = {cz, sz, 0};
  rz.row[1] = {-sz, cz, 0};
  Transform t = from_orthonormal(rx * ry * rz);
  t.kind = TransformKind::rotation;
  return t;
}

Transform Transform::axis_rotation(const Vec3& unit_axis, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  const double x = unit_axis.x, y = unit_axis.y, z = unit_axis.z;
  Matrix m;
  m.row[0] = {x * x + c * (1 - x * x), x * y * (1 - c) + z * s, x * z * (1 - c) - y * s};
  m.row[1] = {x * y * (1 - c) - z * s, y * y + c * (1 - y * y), y * z * (1 - c) + x * s};
  m.row[2] = {x * z * (1 - c) + y * s, y * z * (1 - c) - x * s, z * z + c * (1 - z * z)};
  return from_orthonormal(m);
}

Transform Transform::rotation_from_z(const Vec3& unit_axis) {
  // For axes along ±z any perpendicular will do; nearly so counts as well (measured on povray 3.7), also
  // what rounding leaves out of the length of 1, which would tilt them by 1e-8.
  if (1.0 - std::abs(unit_axis.z) < 1e-10) {
    return axis_rotation({1, 0, 0}, std::acos(unit_axis.z < 0 ? -1 : 1));
  }
  return axis_rotation(unit_or_zero({-unit_axis.y, unit_axis.x, 0}), std::acos(unit_axis.z));
}

bool Transform::from_matrix(const Matrix& m, Transform& result) {
  Matrix4 whole, inverse;
  for (int i = 0; i < 4; ++i) whole[i] = {m.row[i].x, m.row[i].y, m.row[i].z, i == 3 ? 1.0 : 0.0};
  if (!invert(whole, inverse)) return false;
  result.forward = m;
  for (int i = 0; i < 4; ++i) result.inverse.row[i] = {inverse[i][0], inverse[i][1], inverse[i][2]};
  return true;
}

Transform Transform::then(const Transform& next) const {
  return {next.inverse * inverse, forward * next.forward};
}

Bounds Transform::bounds(const Bounds& local) const {
  if (local.is_empty()) return local;
  if (!local.is_bounded()) return Bounds::everything();
  // Arvo: each output axis takes the smaller and the larger product of each input axis.
  Bounds result{forward.row[3], forward.row[3]};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double low = forward.row[i][j] * local.min[i];
      const double high = forward.row[i][j] * local.max[i];
      result.min[j] += low < high ? low : high;
      result.max[j] += low < high ? high : low;
    }
  }
  return result;
}

}  // namespace durer
