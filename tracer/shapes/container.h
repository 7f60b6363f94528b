// contained_by {} of isosurface and parametric (spec/functions.md 7.3, step 1).
#pragma once

#include "tracer/shapes/box_crossing.h"

namespace durer {

class Container {
 public:
  explicit Container(const ContainerNode& node);

  Bounds bounds() const;
  bool contains(const Vec3& p) const;  // the border included
  // near of a sphere may be negative. Sides are those of a box, kNoSide for a sphere.
  bool cross(const ShapeRay& ray, BoxCrossing& crossing) const;
  // The sphere's normal at a point on its surface; false elsewhere and for a box.
  bool sphere_normal(const Vec3& p, Vec3& normal) const;

 private:
  bool is_sphere_;
  Vec3 low_, high_, center_;
  double radius_;
};

}  // namespace durer
