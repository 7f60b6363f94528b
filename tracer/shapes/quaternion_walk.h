// The walk along a ray through a julia set of quaternions.
#pragma once

#include "tracer/shapes/julia_maps.h"

namespace durer {

// Whether a point is in the set; finds how far the set is where it is not.
bool look_for_set(const QuaternionSquare&, const JuliaSlice&, const Vec3& point, double& distance);
bool look_for_set(const QuaternionCube&, const JuliaSlice&, const Vec3& point, double& distance);

struct QuaternionWalk {
  const Vec3& direction;
  double end;        // of the ray
  double precision;  // the shortest step
  // Where it is, and how far the set is from there.
  Vec3& point;
  double& t;
  double& distance;
};

// Goes on to the last point before one that is in the set. False: it comes to the end of the ray.
bool approach_set(const QuaternionSquare&, const JuliaSlice&, const QuaternionWalk&);
bool approach_set(const QuaternionCube&, const JuliaSlice&, const QuaternionWalk&);

// Goes on within the set, in steps of the precision, to the last point before one that is not; likewise.
bool cross_set(const QuaternionSquare&, const JuliaSlice&, const QuaternionWalk&);
bool cross_set(const QuaternionCube&, const JuliaSlice&, const QuaternionWalk&);

// Where a ray crosses the border within a step from a place on.
JuliaPlace find_border(const QuaternionSquare&, const JuliaSlice&, const JuliaPlace&, double step,
                       const Vec3& direction, bool was_inside);
JuliaPlace find_border(const QuaternionCube&, const JuliaSlice&, const JuliaPlace&, double step,
                       const Vec3& direction, bool was_inside);

}  // namespace durer
