// What the two sweeps along a ray through CSG of convex solids share.
#pragma once

#include <cstdint>

#include "tracer/intersect/geometry.h"

namespace durer {

inline constexpr uint32_t kMostSweptSolids = 16;
// Of one intersection, and how many of those that are cut out of it a ray may meet.
inline constexpr uint32_t kMostIntersectedSolids = 4096;
inline constexpr int kMostCuts = 64;
// Where on the ray a sweep starts: before all hits that count.
inline constexpr double kSweepStart = 0.5 * kLeastHitDepth;
// Crossings of two solids closer than this share of their depth are doubtful.
inline constexpr double kSweepDoubt = 1e-7;

// A solid, or a half space, of a CSG as one ray meets it.
class SweptSolid {
 public:
  SweptSolid(const Geometry& geometry, const GeometryNode& node, const GeometryRay& ray)
      : node_(node),
        ray_(ray),
        transform_(node.transform < 0 ? nullptr : &geometry.transforms[node.transform]) {}

  // Finds the crossings if there may be any in [low, high].
  [[gnu::always_inline]] void find_crossings(double low, double high, bool look_at_box,
                                             HitStack& stack) {
    if (look_at_box && node_.is_boxed) ray_.clip(node_.reach, low, high);
    if (!(low <= high * (1 + 1e-12))) return;
    ShapeRay local = shape_ray(ray_, transform_);
    local.csg_child = true;
    node_.shape->line_hits(local, crossings);
    stack.count_test(node_.shape_kind, crossings.count > 0);
  }
  // Whether the sweep starts in it, `inverse` or not.
  bool holds_start() const {
    const Vec3 start = ray_.origin + kSweepStart * ray_.direction;
    return node_.shape->inside(transform_ ? transform_->inverse_point(start) : start) !=
           node_.holds_outside;
  }

  LineHits crossings;

 private:
  const GeometryNode& node_;
  const GeometryRay& ray_;
  const Transform* transform_;
};

}  // namespace durer
