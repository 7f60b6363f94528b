// What rays meet, as flat arrays: shapes with their transforms, and CSG over them (spec/geometry.md
// 2, 6). Immutable while rays fly. Knows shapes and flags by number, nothing of textures.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "tracer/intersect/bvh.h"
#include "tracer/shapes/shape.h"

namespace durer {

// Bits of a ray's kind and, in GeometryNode::hidden, the kinds that do not see a node.
enum RayKind : uint8_t {
  kImageRay = 1, kReflectionRay = 2, kShadowRay = 4, kPhotonRay = 8, kRadiosityRay = 16,
  kPrimaryRay = 32,
};

enum class NodeKind : uint8_t { shape, union_, merge, intersection, nothing };

struct NodeRange {
  uint32_t first = 0, count = 0;  // in Geometry::lists
};

struct GeometryNode {
  NodeKind kind = NodeKind::nothing;
  uint8_t hidden = 0;           // RayKind bits
  bool inverted = false;        // mark of a shape: turns its inside test and its normal over
  bool written_as_difference = false;
  bool is_opaque = false;       // stops light whatever happens
  bool csg_child = false;
  bool narrows = false;         // a convex solid: an intersection with it lies within its hits
  bool is_half_space = false;
  bool holds_outside = false;   // its shape's inside test is that of what is outside of a convex solid
  bool looks_along_world = false;  // a moved shape whose inside test keeps a direction of the world
  bool is_flat = false;         // `swept` stands for one intersection of all
  bool places_hits = false;     // its shape does
  bool is_boxed = false;        // its box is worth a test before its surface is looked for
  uint8_t shape_kind = 0;       // of a shape: ShapeNode::index()
  bool has_object = true;       // false: a light without looks_like takes no part in inside tests
  // Outside `reach` the node contains all points (true) or none (false); where it is bounded.
  bool contains_outside = false;
  bool surface_is_bounded = false;
  int32_t transform = -1;       // of a shape, in Geometry::transforms
  uint32_t object = 0;          // the caller's number
  const Shape* shape = nullptr;
  NodeRange children, clips, bounds;
  // The convex solids of a CSG for sweep_convex_solids(), if it is one, but for those that are cut
  // out by `tree`; behind them, where it is not flat, the number of its plan.
  NodeRange swept;
  int32_t tree = -1;            // of many children: Geometry::trees
  Bounds reach;                 // the surface and a hair more: outside of it nothing happens
};

// The children of a composite, those with bounded surfaces in a hierarchy.
struct ChildTree {
  Bvh bvh;
  std::vector<uint32_t> bounded;  // child positions in the order of bvh's leaves
  std::vector<uint32_t> others;   // child positions that are always asked
};

// How the convex solids of a CSG go together. Solids are bits, in the order of the tree.
struct SweptPart {
  NodeKind kind;
  uint32_t solids;                     // its own, not its children's
  int32_t parent, first_child, next;  // parts, or -1
};
struct SweepPlan {
  std::vector<SweptPart> parts;  // the whole first
  std::vector<int32_t> part_of;  // the part of each solid
};

struct GeometryRay : BvhRay {
  // Parameters are world distances; directions are of length 1, but not inside instances.
  GeometryRay(const Vec3& from, const Vec3& along, uint8_t ray_kind, bool is_unit = true)
      : BvhRay(from, along), kind(ray_kind) {
    unit_direction = is_unit;
  }

  uint8_t kind;  // RayKind bits
};

// Fills in origin and direction as they are before the transform.
void move_ray(const Transform& transform, const BvhRay& ray, ShapeRay& local);

// A ray as a shape sees it; `transform` may be null.
[[gnu::always_inline]] inline ShapeRay shape_ray(const GeometryRay& ray,
                                                 const Transform* transform) {
  ShapeRay local;
  if (transform) {
    move_ray(*transform, ray, local);
  } else {
    local.origin = ray.origin;
    local.direction = ray.direction;
    local.unit_direction = ray.unit_direction;
  }
  return local;
}

class MergeSpans;

class Geometry {
 public:
  std::vector<GeometryNode> nodes;
  std::vector<uint32_t> lists;
  std::vector<Transform> transforms;
  std::deque<std::shared_ptr<const Shape>> shapes;  // owned; in pieces, to fill gaps
  std::vector<std::unique_ptr<ChildTree>> trees;
  std::vector<SweepPlan> sweep_plans;

  // The nearest hit of one node with kLeastHitDepth <= t < t_max, by the rules for one object
  // (spec/geometry.md 2.1: of equal depths the last pushed wins). No box test, no flags.
  bool closest(uint32_t node, const GeometryRay& ray, double t_max, HitStack& stack,
               ShapeHit& hit) const;
  // All hits within the interval, perhaps also others of a lone shape, in the order of pushing.
  void all_hits(uint32_t node, const GeometryRay& ray, const Interval& wanted,
                HitStack& stack) const;
  // The point of a hit of a shape's node.
  Vec3 hit_point(const GeometryNode& node, const GeometryRay& ray, const ShapeHit& hit) const {
    if (node.places_hits) [[unlikely]] return placed_hit(node, ray, hit);
    return ray.origin + hit.t * ray.direction;
  }
  // bounded_by: each bounding object is hit or contains the origin.
  bool passes_bounds(const GeometryNode& node, const GeometryRay& ray, HitStack& stack) const;
  // With the node's clips.
  bool inside(uint32_t node, const Vec3& point) const;
  bool inside_unclipped(uint32_t node, const Vec3& point) const;

  // Fills in reach, contains_outside and the child tree of a node whose children are done.
  void finish_node(uint32_t node);

 private:
  Vec3 placed_hit(const GeometryNode& node, const GeometryRay& ray, const ShapeHit& hit) const;
  bool inside_clips(const GeometryNode& node, const Vec3& point) const;
  void shape_hits(uint32_t index, const GeometryRay& ray, HitStack& stack) const;
  bool closest_of_union(const GeometryNode& node, const GeometryRay& ray, double t_max,
                        HitStack& stack, ShapeHit& hit) const;
  // convex_csg.cpp
  enum class Sweep : uint8_t { missed, met, doubtful };
  bool gather_convex_solids(uint32_t node, int32_t parent, std::vector<uint32_t>& solids,
                            SweepPlan& plan) const;
  // convex_intersection.cpp, where the node is flat
  struct IntersectionSpans;
  Sweep narrow_spans(uint32_t solid, bool look_at_box, const GeometryRay& ray, double t_max,
                     HitStack& stack, IntersectionSpans& spans) const;
  Sweep cut_out_tree(const GeometryNode& node, const GeometryRay& ray, double t_max,
                     HitStack& stack, IntersectionSpans& spans) const;
  Sweep find_spans(const GeometryNode& node, const GeometryRay& ray, double t_max, HitStack& stack,
                   IntersectionSpans& spans) const;
  bool all_others_hold(const GeometryNode& node, uint32_t except, const Vec3& point) const;
  Sweep settle_sweep(const GeometryNode& node, const GeometryRay& ray, double from, double t_max,
                     const IntersectionSpans& spans, HitStack& stack, ShapeHit& hit) const;
  // Pushes all hits; some, where it ends in doubt.
  Sweep sweep_all_of_intersection(const GeometryNode& node, const GeometryRay& ray, double t_max,
                                  HitStack& stack) const;
  Sweep sweep_convex_intersection(const GeometryNode& node, const GeometryRay& ray, double t_max,
                                  HitStack& stack, ShapeHit& hit) const;
  Sweep sweep_convex_solids(const GeometryNode& node, const GeometryRay& ray, double t_max,
                            HitStack& stack, ShapeHit& hit) const;
  bool closest_of_composite(const GeometryNode& node, const GeometryRay& ray, double t_max,
                            HitStack& stack, ShapeHit& hit) const;
  bool member_hits(const GeometryNode& node, uint32_t child, const GeometryRay& ray,
                   Interval& interval, HitStack& stack) const;
  struct GatheredHits;
  enum class Gathering : uint8_t { whole, missed, overflowed };
  Gathering gather_hits(const GeometryNode& node, const GeometryRay& ray, Interval& interval,
                        HitStack& stack, GatheredHits& gathered) const;
  void note_span(uint32_t child, const GeometryRay& ray, const HitStack& stack, size_t first,
                 MergeSpans& spans) const;
  template <typename Visit>
  void for_each_child_met(const GeometryNode& node, const GeometryRay& ray,
                          const Interval& interval, Visit&& visit) const;
  void take_in_own_kind(GeometryNode& node);
  void plan_sweep(uint32_t index);
  void enclose(uint32_t node);
  bool keeps_hit(const GeometryNode& node, uint32_t child, const Vec3& point, uint8_t kind) const;
  bool takes_part(const GeometryNode& parent, const GeometryNode& child, uint8_t kind) const;
  bool all_or_none(const GeometryNode& node, const Vec3& point, bool wanted, uint32_t except,
                   uint8_t kind) const;
};

}  // namespace durer
