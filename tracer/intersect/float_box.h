// The boxes that POV-Ray keeps: lower corner and edge lengths in single precision. They decide what
// is visible, and are what min_extent() and max_extent() report (spec/geometry.md 2.2, 4.2, 6.6).
#pragma once

#include "tracer/math/transform.h"

namespace durer {

struct FloatBox {
  float lower[3] = {-1e10f, -1e10f, -1e10f};
  float length[3] = {2e10f, 2e10f, 2e10f};

  static FloatBox from(const Bounds& bounds);
  Bounds to_bounds() const;
  // Its far corner not rounded: so unions and clips see it.
  Bounds to_double_bounds() const;
  float volume() const { return length[0] * length[1] * length[2]; }
  // No longer than the reference's limit for finite objects.
  bool is_infinite() const { return volume() > 2e10f; }
  // Box of the eight transformed corners, cut off at ±1e10.
  FloatBox transformed(const Transform& transform) const;
  bool contains(const Vec3& p) const;
  // Whether a ray meets the box, with POV-Ray's single-precision slab distances (2.2). A ray in the
  // plane of a face across y or z does; in that of a face across x it does in a hierarchy, but not
  // where an object's own box is asked (measured on povray 3.7).
  bool is_met(const Vec3& origin, const Vec3& direction) const {
    return is_met(origin, direction, false);
  }
  bool is_met_in_hierarchy(const Vec3& origin, const Vec3& direction) const {
    return is_met(origin, direction, true);
  }

 private:
  bool is_met(const Vec3& origin, const Vec3& direction, bool in_x_face) const;
};

}  // namespace durer
