#include "tracer/intersect/geometry.h"

#include <algorithm>
#include <cmath>

#include "tracer/intersect/bvh_walk.h"
#include "tracer/intersect/convex_sweep.h"
#include "tracer/intersect/merge_spans.h"

namespace durer {
namespace {

// The next double up: lets a later child take over at equal depth.
double just_beyond(double t) { return std::nextafter(t, HUGE_VAL); }

// Whether a ray is in a box somewhere on an interval. The interval stays as it is: rounding puts
// some of the hits of swept shapes outside of their boxes, and povray takes those of rays that meet
// the box.
bool meets(const Bounds& box, const BvhRay& ray, const Interval& interval) {
  double low = interval.min, high = interval.max;
  ray.clip(box, low, high);
  return low <= high * (1 + 1e-12);
}

// Members of an intersection that a ray crosses once narrow the way on which the others count: by
// this much less, so that hits on the border are left to the inside tests.
constexpr double kBorder = 1e-7;

// Which children of a composite a ray may meet, in order. Lists longer than the stack buffer are
// not culled.
class ChildPicker {
 public:
  static constexpr int kCapacity = 512;

  void add(uint32_t child) {
    if (count_ < kCapacity) child_[count_] = child;
    ++count_;
  }
  bool overflowed() const { return count_ > kCapacity; }
  void sort() { std::sort(child_, child_ + count_); }
  const uint32_t* begin() const { return child_; }
  const uint32_t* end() const { return child_ + count_; }

 private:
  uint32_t child_[kCapacity];
  int count_ = 0;
};

}  // namespace

bool Geometry::takes_part(const GeometryNode& parent, const GeometryNode& child,
                          uint8_t kind) const {
  if (!child.hidden || parent.kind == NodeKind::intersection) return true;
  if (kind & kPhotonRay) return !(child.hidden & kPhotonRay);
  if ((kind & kImageRay) && (child.hidden & kImageRay)) {
    // Camera rays see no_image members of an unsplit union, not those of a merge.
    if (parent.kind == NodeKind::merge || !(kind & kPrimaryRay)) return false;
  }
  return !(kind & child.hidden & (kReflectionRay | kRadiosityRay));
}

bool Geometry::inside_clips(const GeometryNode& node, const Vec3& point) const {
  for (uint32_t i = 0; i < node.clips.count; ++i) {
    if (!inside(lists[node.clips.first + i], point)) return false;
  }
  return true;
}

bool Geometry::inside(uint32_t index, const Vec3& point) const {
  const GeometryNode& node = nodes[index];
  return (node.clips.count == 0 || inside_clips(node, point)) && inside_unclipped(index, point);
}

bool Geometry::inside_unclipped(uint32_t index, const Vec3& point) const {
  const GeometryNode& node = nodes[index];
  switch (node.kind) {
    case NodeKind::shape: {
      if (node.looks_along_world) [[unlikely]] {
        const Transform& placement = transforms[node.transform];
        return node.shape->inside_moved(placement.inverse_point(point), placement, node.inverted);
      }
      const Vec3 local =
          node.transform < 0 ? point : transforms[node.transform].inverse_point(point);
      return node.inverted ? node.shape->inside_inverted(local) : node.shape->inside(local);
    }
    case NodeKind::union_:
    case NodeKind::merge: return !all_or_none(node, point, false, UINT32_MAX, 0);
    case NodeKind::intersection: return all_or_none(node, point, true, UINT32_MAX, 0);
    default: return false;
  }
}

// Whether `inside` of every child but one (a node number) equals `wanted`.
bool Geometry::all_or_none(const GeometryNode& node, const Vec3& point, bool wanted,
                           uint32_t except, uint8_t kind) const {
  const uint32_t* child = lists.data() + node.children.first;
  const auto agrees = [&](uint32_t c) {
    const GeometryNode& other = nodes[c];
    if (c == except || !other.has_object) return true;
    if (kind && !takes_part(node, other, kind)) return true;
    return inside(c, point) == wanted;
  };
  if (node.tree < 0) {
    for (uint32_t i = 0; i < node.children.count; ++i) {
      const GeometryNode& other = nodes[child[i]];
      // Far from its surface a bounded child is all in or all out.
      if (other.surface_is_bounded && other.contains_outside == wanted &&
          !other.reach.contains(point)) {
        continue;
      }
      if (!agrees(child[i])) return false;
    }
    return true;
  }
  const ChildTree& tree = *trees[node.tree];
  for (const uint32_t i : tree.others) {
    if (!agrees(child[i])) return false;
  }
  bool agreed = true;
  tree.bvh.visit_point(point, [&](uint32_t position) {
    agreed = agrees(child[tree.bounded[position]]);
    return !agreed;
  });
  return agreed;
}

bool Geometry::keeps_hit(const GeometryNode& node, uint32_t child, const Vec3& point,
                         uint8_t kind) const {
  if (node.clips.count && !inside_clips(node, point)) return false;
  if (node.kind == NodeKind::union_) return true;
  if (node.kind == NodeKind::intersection) return all_or_none(node, point, true, child, 0);
  return all_or_none(node, point, false, child, kind);
}

bool Geometry::passes_bounds(const GeometryNode& node, const GeometryRay& ray,
                             HitStack& stack) const {
  for (uint32_t i = 0; i < node.bounds.count; ++i) {
    const uint32_t bound = lists[node.bounds.first + i];
    ShapeHit hit;
    if (!closest(bound, ray, kHugeDepth, stack, hit) && !inside(bound, ray.origin)) return false;
  }
  return true;
}

void Geometry::shape_hits(uint32_t index, const GeometryRay& ray, HitStack& stack) const {
  const GeometryNode& node = nodes[index];
  const size_t base = stack.size();
  stack.owner = index;
  ShapeRay local = shape_ray(ray, node.transform < 0 ? nullptr : &transforms[node.transform]);
  // The first hit may be clipped away.
  local.is_clipped = node.clips.count != 0;
  local.csg_child = node.csg_child || local.is_clipped;
  node.shape->hits(local, stack);
  stack.count_test(node.shape_kind, stack.size() > base);
  if (node.clips.count == 0) return;
  size_t kept = base;
  for (size_t i = base; i < stack.size(); ++i) {
    if (inside_clips(node, ray.origin + stack[i].t * ray.direction)) stack[kept++] = stack[i];
  }
  stack.shrink(kept);
}

Vec3 Geometry::placed_hit(const GeometryNode& node, const GeometryRay& ray,
                          const ShapeHit& hit) const {
  if (node.transform < 0) return node.shape->place(shape_ray(ray, nullptr), hit);
  const Transform& transform = transforms[node.transform];
  return transform.point(node.shape->place(shape_ray(ray, &transform), hit));
}

// visit(child node) for the children that the ray may meet within the interval, in order, until one
// returns false. Visits may narrow the interval.
template <typename Visit>
void Geometry::for_each_child_met(const GeometryNode& node, const GeometryRay& ray,
                                  const Interval& interval, Visit&& visit) const {
  const uint32_t* child = lists.data() + node.children.first;
  if (node.tree >= 0) {
    const ChildTree& tree = *trees[node.tree];
    ChildPicker picker;
    for (const uint32_t i : tree.others) picker.add(i);
    tree.bvh.visit_ray<true>(ray, interval.max, [&](uint32_t first, uint32_t count, double&) {
      for (uint32_t i = first; i < first + count; ++i) picker.add(tree.bounded[i]);
      return picker.overflowed();
    });
    if (!picker.overflowed()) {
      picker.sort();
      for (const uint32_t i : picker) {
        if (!visit(child[i])) return;
      }
      return;
    }
  }
  for (uint32_t i = 0; i < node.children.count; ++i) {
    if (!visit(child[i])) return;
  }
}

// Pushes a member's hits on the interval, in the order in which a composite passes them on: popped
// and pushed again, so reversed. False: the ray misses the whole intersection on the interval.
bool Geometry::member_hits(const GeometryNode& node, uint32_t child, const GeometryRay& ray,
                           Interval& interval, HitStack& stack) const {
  const GeometryNode& member = nodes[child];
  if (!takes_part(node, member, ray.kind)) return true;
  const bool narrows = member.narrows && node.kind == NodeKind::intersection;
  if (member.is_boxed && !meets(member.reach, ray, interval)) return !narrows;
  if (member.bounds.count && !passes_bounds(member, ray, stack)) return true;
  const size_t base = stack.size();
  all_hits(child, ray, interval, stack);
  if (narrows) {
    // What lies outside of this member counts no more.
    const size_t count = stack.size() - base;
    if (count == 0) return false;
    double first = stack[base].t, last = first;
    for (size_t i = base + 1; i < stack.size(); ++i) {
      first = std::min(first, stack[i].t);
      last = std::max(last, stack[i].t);
    }
    const double border = kBorder * (1 + last);
    if (count > 1) interval.min = std::max(interval.min, first - border);
    // A single hit is where the ray leaves, unless rounding took the other.
    if (count > 1 || inside_unclipped(child, ray.origin)) {
      interval.max = std::min(interval.max, last + border);
    }
    if (interval.min > interval.max) return false;
  }
  for (size_t i = base, j = stack.size(); i + 1 < j; ++i) std::swap(stack[i], stack[--j]);
  size_t kept = base;
  for (size_t i = base; i < stack.size(); ++i) {
    if (stack[i].t <= interval.max && stack[i].t >= interval.min) stack[kept++] = stack[i];
  }
  stack.shrink(kept);
  return true;
}

// The members' hits, and whose they are.
struct Geometry::GatheredHits {
  static constexpr size_t kMost = 128;
  uint32_t member[kMost];
  MergeSpans spans;  // of a merge
};

Geometry::Gathering Geometry::gather_hits(const GeometryNode& node, const GeometryRay& ray,
                                          Interval& interval, HitStack& stack,
                                          GatheredHits& gathered) const {
  const size_t base = stack.size();
  Gathering result = Gathering::whole;
  for_each_child_met(node, ray, interval, [&](uint32_t child) {
    const size_t first = stack.size();
    if (!member_hits(node, child, ray, interval, stack)) {
      result = Gathering::missed;
    } else if (stack.size() - base > GatheredHits::kMost) {
      result = Gathering::overflowed;
    } else {
      std::fill(gathered.member + (first - base), gathered.member + (stack.size() - base), child);
      if (node.kind == NodeKind::merge) note_span(child, ray, stack, first, gathered.spans);
    }
    return result == Gathering::whole;
  });
  return result;
}

// Notes where a convex member of a merge holds the ray; its hits are the stack's from `first` on.
void Geometry::note_span(uint32_t child, const GeometryRay& ray, const HitStack& stack, size_t first,
                         MergeSpans& spans) const {
  const size_t count = stack.size() - first;
  if (!nodes[child].narrows || count == 0 || count > 2) return;
  const double one = stack[first].t, other = stack[stack.size() - 1].t;
  if (count == 2) {
    spans.add(std::min(one, other), std::max(one, other));
  } else if (inside_unclipped(child, ray.origin)) {
    spans.add(0, one);
  }
}

void Geometry::all_hits(uint32_t index, const GeometryRay& ray, const Interval& wanted,
                        HitStack& stack) const {
  const GeometryNode& node = nodes[index];
  if (node.kind == NodeKind::nothing) return;
  if (node.kind == NodeKind::shape) {
    shape_hits(index, ray, stack);
    return;
  }
  Interval interval = wanted;
  if (node.is_boxed && !meets(node.reach, ray, interval)) return;
  const size_t start = stack.size();
  if (node.is_flat) {
    if (sweep_all_of_intersection(node, ray, wanted.max, stack) != Sweep::doubtful) return;
    stack.shrink(start);
  }
  if (node.kind == NodeKind::union_ && node.clips.count == 0) {
    for_each_child_met(node, ray, interval, [&](uint32_t child) {
      const GeometryNode& member = nodes[child];
      if (!takes_part(node, member, ray.kind)) return true;
      if (member.is_boxed && !meets(member.reach, ray, interval)) return true;
      if (member.bounds.count && !passes_bounds(member, ray, stack)) return true;
      all_hits(child, ray, interval, stack);
      return true;
    });
    return;
  }
  if (node.kind == NodeKind::merge) {
    GatheredHits gathered;
    if (gather_hits(node, ray, interval, stack, gathered) == Gathering::whole) {
      size_t kept = start;
      for (size_t i = start; i < stack.size(); ++i) {
        const uint32_t child = gathered.member[i - start];
        const double t = stack[i].t;
        if (gathered.spans.covered_from(t) == 0 &&
            keeps_hit(node, child, ray.origin + t * ray.direction, ray.kind)) {
          stack[kept++] = stack[i];
        }
      }
      stack.shrink(kept);
      return;
    }
    stack.shrink(start);
  }
  for_each_child_met(node, ray, interval, [&](uint32_t child) {
    const size_t base = stack.size();
    if (!member_hits(node, child, ray, interval, stack)) {
      stack.shrink(start);
      return false;
    }
    size_t kept = base;
    for (size_t i = base; i < stack.size(); ++i) {
      if (keeps_hit(node, child, ray.origin + stack[i].t * ray.direction, ray.kind)) {
        stack[kept++] = stack[i];
      }
    }
    stack.shrink(kept);
    return true;
  });
}

// The nearest of the children; of equal ones the last.
bool Geometry::closest_of_union(const GeometryNode& node, const GeometryRay& ray, double t_max,
                                HitStack& stack, ShapeHit& hit) const {
  double best = t_max;
  int64_t position = -1;
  const auto test = [&](uint32_t i) {
    const uint32_t child = lists[node.children.first + i];
    const GeometryNode& member = nodes[child];
    if (!takes_part(node, member, ray.kind)) return;
    if (member.bounds.count && !passes_bounds(member, ray, stack)) return;
    const double limit = position >= 0 && i > position ? just_beyond(best) : best;
    // Hierarchies have looked at the boxes; intersections and merges look at their own.
    if (node.tree < 0 && member.is_boxed &&
        (member.kind == NodeKind::shape || member.kind == NodeKind::union_ || member.is_flat) &&
        !meets(member.reach, ray, {kLeastHitDepth, limit})) {
      return;
    }
    ShapeHit candidate;
    if (!closest(child, ray, limit, stack, candidate)) return;
    hit = candidate;
    best = hit.t;
    position = i;
  };
  if (node.tree < 0) {
    for (uint32_t i = 0; i < node.children.count; ++i) test(i);
    return position >= 0;
  }
  const ChildTree& tree = *trees[node.tree];
  for (const uint32_t i : tree.others) test(i);
  tree.bvh.visit_ray(ray, best, [&](uint32_t first, uint32_t count, double& limit) {
    for (uint32_t i = first; i < first + count; ++i) test(tree.bounded[i]);
    limit = best;
    return false;
  });
  return position >= 0;
}

// All members' hits are gathered first; then the nearest that the others let stand is looked for.
bool Geometry::closest_of_composite(const GeometryNode& node, const GeometryRay& ray,
                                    double t_max, HitStack& stack, ShapeHit& hit) const {
  Interval interval{kLeastHitDepth, t_max};
  // Of one intersection each solid's own box says as much.
  if (node.is_boxed && !node.is_flat && !meets(node.reach, ray, interval)) return false;
  if (node.swept.count) {
    const Sweep sweep = node.is_flat ? sweep_convex_intersection(node, ray, t_max, stack, hit)
                                     : sweep_convex_solids(node, ray, t_max, stack, hit);
    if (sweep != Sweep::doubtful) return sweep == Sweep::met;
  }
  if (node.is_boxed && node.is_flat && !meets(node.reach, ray, interval)) return false;
  const size_t base = stack.size();
  GatheredHits gathered;
  const Gathering gathering = gather_hits(node, ray, interval, stack, gathered);
  const bool overflowed = gathering == Gathering::overflowed;
  if (overflowed) {
    stack.shrink(base);
    all_hits(static_cast<uint32_t>(&node - nodes.data()), ray, {kLeastHitDepth, t_max}, stack);
  }
  bool found = false;
  double from = interval.min;
  while (gathering != Gathering::missed && !found) {
    // Of equal depths the one pushed last wins.
    double best = t_max;
    size_t chosen = 0;
    for (size_t i = stack.size(); i-- > base;) {
      if (stack[i].t < best && stack[i].t >= from) {
        best = stack[i].t;
        chosen = i;
        found = true;
      }
    }
    if (!found) break;
    hit = stack[chosen];
    stack[chosen].t = kHugeDepth;
    if (overflowed) break;
    const uint32_t child = gathered.member[chosen - base];
    const double covered = gathered.spans.covered_from(best);
    from = std::max(from, covered);
    found = covered == 0 && keeps_hit(node, child, ray.origin + best * ray.direction, ray.kind);
  }
  stack.shrink(base);
  return found;
}

bool Geometry::closest(uint32_t index, const GeometryRay& ray, double t_max, HitStack& stack,
                       ShapeHit& hit) const {
  const GeometryNode& node = nodes[index];
  if (node.clips.count) {
    if (node.kind != NodeKind::shape) return closest_of_composite(node, ray, t_max, stack, hit);
    // A clipped shape: the nearest of what is left of its hits.
    const size_t base = stack.size();
    shape_hits(index, ray, stack);
    bool found = false;
    for (size_t i = stack.size(); i-- > base;) {
      if (stack[i].t >= t_max || stack[i].t < kLeastHitDepth) continue;
      t_max = stack[i].t;
      hit = stack[i];
      found = true;
    }
    stack.shrink(base);
    return found;
  }
  switch (node.kind) {
    case NodeKind::shape: {
      ShapeRay local =
          shape_ray(ray, node.transform < 0 ? nullptr : &transforms[node.transform]);
      local.csg_child = node.csg_child;
      local.t_max = t_max;
      const bool found = node.shape->closest(local, stack, hit);
      stack.count_test(node.shape_kind, found);
      if (found) hit.node = index;
      return found;
    }
    case NodeKind::union_: return closest_of_union(node, ray, t_max, stack, hit);
    case NodeKind::nothing: return false;
    default: return closest_of_composite(node, ray, t_max, stack, hit);
  }
}

}  // namespace durer
