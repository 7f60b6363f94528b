// Points, directions and colours' carriers: GLM's double vectors under the names the house uses.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace durer {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using glm::cross;
using glm::dot;
using glm::length;

// v/|v|; the zero vector stays zero.
inline Vec3 normalize_or_zero(const Vec3& v) {
  const double squared = dot(v, v);
  return squared > 0 ? v / __builtin_sqrt(squared) : v;
}
// The same by one division, so a last digit apart: for rays and shading.
inline Vec3 unit_or_zero(const Vec3& v) {
  const double squared = dot(v, v);
  // Normals of planes and boxes are of length 1 already.
  return squared > 0 && squared != 1 ? v * (1 / __builtin_sqrt(squared)) : v;
}

}  // namespace durer
