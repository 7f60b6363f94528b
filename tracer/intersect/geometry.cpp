#include "tracer/intersect/geometry.h"

#include <algorithm>
#include <cmath>

#include "tracer/intersect/bvh_walk.h"
#include "tracer/intersect/convex_sweep.h"
#include "tracer/intersect/merge_spans.h"

namespace durer {
namespace {

// Composites with at least this many children get a hierarchy (performance.md 4).
constexpr uint32_t kTreeThreshold = 24;

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

void Geometry::finish_node(uint32_t index) {
  GeometryNode& node = nodes[index];
  if (node.kind == NodeKind::merge || node.kind == NodeKind::union_) take_in_own_kind(node);
  enclose(index);
  // A sphere or box in place is met or missed as fast as its bounds; so is an intersection that
  // starts with one.
  const auto is_quick = [](const GeometryNode& n) {
    return n.kind == NodeKind::shape && n.transform < 0 && n.shape->is_quickly_missed();
  };
  node.is_boxed = node.surface_is_bounded && !is_quick(node);
  if (node.kind == NodeKind::shape) {
    const Shape& shape = *node.shape;
    node.narrows = shape.is_convex_solid() && !node.inverted && node.clips.count == 0 &&
                   node.bounds.count == 0;
    node.places_hits = shape.places_hits();
    node.is_half_space = shape.is_half_space();
    node.looks_along_world = node.transform >= 0 && shape.looks_along_world();
    node.holds_outside = shape.is_outside_of_convex();
    return;
  }
  if (node.kind == NodeKind::intersection || node.kind == NodeKind::merge) plan_sweep(index);
  if (node.kind == NodeKind::intersection && node.children.count > 0 && node.tree < 0) {
    const GeometryNode& first = nodes[lists[node.children.first]];
    node.is_boxed &= !(first.narrows && is_quick(first));
  }
}

// Notes the convex solids of a CSG, where it is made of them alone.
void Geometry::plan_sweep(uint32_t index) {
  GeometryNode& node = nodes[index];
  std::vector<uint32_t> solids;
  SweepPlan plan;
  if (!gather_convex_solids(index, -1, solids, plan)) return;
  const bool is_flat =
      std::all_of(plan.parts.begin(), plan.parts.end(),
                  [](const SweptPart& part) { return part.kind == NodeKind::intersection; });
  if (solids.size() > kMostSweptSolids && !is_flat) return;
  if (node.tree >= 0) {
    // What stands in the hierarchy is cut out through it.
    solids.clear();
    for (const uint32_t i : trees[node.tree]->others) {
      solids.push_back(lists[node.children.first + i]);
    }
  }
  node.swept = {static_cast<uint32_t>(lists.size()), static_cast<uint32_t>(solids.size())};
  node.is_flat = is_flat;
  // What is cut out comes last: most rays miss what it is cut out of.
  if (is_flat) {
    std::stable_partition(solids.begin(), solids.end(),
                          [&](uint32_t solid) { return !nodes[solid].inverted; });
  }
  lists.insert(lists.end(), solids.begin(), solids.end());
  if (!is_flat) {
    lists.push_back(static_cast<uint32_t>(sweep_plans.size()));
    sweep_plans.push_back(std::move(plan));
  }
}

// A merge of merges is one of all their members: where those are many, one hierarchy holds them. So
// are unions of unions, but for those that have a hierarchy: it serves as well. Hits come in the
// same order, as a merge passes on its members' hits reversed and a union as they are.
void Geometry::take_in_own_kind(GeometryNode& node) {
  std::vector<uint32_t> all;
  const bool is_merge = node.kind == NodeKind::merge;
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const uint32_t child = lists[node.children.first + i];
    const GeometryNode& member = nodes[child];
    const uint32_t* own = lists.data() + member.children.first;
    const bool is_plain =
        member.kind == node.kind && (is_merge || member.tree < 0) && !member.hidden &&
        member.clips.count == 0 && member.bounds.count == 0 &&
        std::all_of(own, own + member.children.count, [&](uint32_t c) { return !nodes[c].hidden; });
    if (!is_plain) {
      all.push_back(child);
      continue;
    }
    if (is_merge) {
      for (uint32_t k = member.children.count; k-- > 0;) all.push_back(own[k]);
    } else {
      all.insert(all.end(), own, own + member.children.count);
    }
  }
  if (all.size() == node.children.count || (is_merge && all.size() < kTreeThreshold)) return;
  node.children = {static_cast<uint32_t>(lists.size()), static_cast<uint32_t>(all.size())};
  lists.insert(lists.end(), all.begin(), all.end());
}

void Geometry::enclose(uint32_t index) {
  GeometryNode& node = nodes[index];
  node.reach = Bounds::everything();
  if (node.kind == NodeKind::shape) {
    Bounds box = node.shape->bounds();
    if (!box.is_empty() && box.is_bounded() && node.shape->is_solid_within_bounds()) {
      if (node.transform >= 0) box = transforms[node.transform].bounds(box);
      const Vec3 margin = 2e-9 * (glm::abs(box.min) + glm::abs(box.max)) + Vec3(1e-9);
      node.reach = {box.min - margin, box.max + margin};
      node.surface_is_bounded = box.is_bounded();
      node.contains_outside = node.inverted && !node.shape->is_patch();
    }
    // A clipped solid contains nothing outside of its clips.
    if (node.clips.count) node.contains_outside = false;
    if (node.clips.count && node.inverted) node.surface_is_bounded = false;
    return;
  }
  if (node.kind == NodeKind::nothing) return;

  // Bounds of the surface. An intersection lies within each member that is empty outside its own;
  // otherwise the members' surfaces enclose it.
  const uint32_t* child = lists.data() + node.children.first;
  const bool is_intersection = node.kind == NodeKind::intersection;
  Bounds joined, common = Bounds::everything();
  bool all_bounded = true, has_common = false;
  bool outside = is_intersection;
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const GeometryNode& member = nodes[child[i]];
    if (!member.has_object) continue;
    if (!member.surface_is_bounded) {
      all_bounded = false;
      continue;
    }
    joined.extend(member.reach);
    if (member.contains_outside != is_intersection) outside = !is_intersection;
    if (is_intersection && !member.contains_outside) {
      common.clip(member.reach);
      has_common = true;
    }
  }
  if (is_intersection && has_common) {
    node.reach = common;
    node.surface_is_bounded = true;
    node.contains_outside = false;
    if (common.is_empty()) node.kind = NodeKind::nothing;
  } else if (all_bounded && !joined.is_empty()) {
    node.reach = joined;
    node.surface_is_bounded = true;
    node.contains_outside = outside;
  }
  if (node.clips.count) {
    if (node.contains_outside) node.surface_is_bounded = false;
    node.contains_outside = false;
  }

  if (node.children.count < kTreeThreshold) return;
  auto tree = std::make_unique<ChildTree>();
  std::vector<Bounds> boxes;
  std::vector<uint32_t> bounded;
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const GeometryNode& member = nodes[child[i]];
    if (member.kind == NodeKind::nothing && !member.has_object) continue;
    // Members that decide far from their surface are always asked.
    if (member.surface_is_bounded && member.contains_outside == is_intersection &&
        !member.reach.is_empty()) {
      bounded.push_back(i);
      boxes.push_back(member.reach);
    } else {
      tree->others.push_back(i);
    }
  }
  if (boxes.size() < kTreeThreshold) return;
  tree->bvh.build(boxes);
  for (const uint32_t item : tree->bvh.items()) tree->bounded.push_back(bounded[item]);
  node.tree = static_cast<int32_t>(trees.size());
  trees.push_back(std::move(tree));
}

}  // namespace durer
