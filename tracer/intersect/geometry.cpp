#include "tracer/intersect/geometry.h"

#include <algorithm>
#include <cmath>

namespace durer {
namespace {

// Composites with at least this many children get a hierarchy (performance.md 4).
constexpr uint32_t kTreeThreshold = 24;

ShapeRay local_ray(const Geometry& geometry, const GeometryNode& node, const GeometryRay& ray) {
  ShapeRay local;
  if (node.transform < 0) {
    local.origin = ray.origin;
    local.direction = ray.direction;
    local.unit_direction = ray.unit;
  } else {
    const Transform& t = geometry.transforms[node.transform];
    local.origin = t.inverse_point(ray.origin);
    local.direction = t.inverse_direction(ray.direction);
  }
  local.csg_child = node.csg_child;
  return local;
}

// The next double up: lets a later child take over at equal depth.
double just_beyond(double t) { return std::nextafter(t, HUGE_VAL); }

// The ray's interval within a box that is widened by a hair; empty: low > high.
Interval clip_to(const Bounds& box, const GeometryRay& ray) {
  double low = 0, high = kHugeDepth;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis], o = ray.origin[axis];
    const double margin = 1e-9 * (std::abs(box.min[axis]) + std::abs(box.max[axis])) + 1e-9;
    if (d == 0) {
      if (o < box.min[axis] - margin || o > box.max[axis] + margin) return {1, 0};
      continue;
    }
    const double a = (box.min[axis] - margin - o) / d, b = (box.max[axis] + margin - o) / d;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return {low, high * (1 + 1e-12)};
}

bool near_box(const Bounds& box, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    const double margin = 1e-9 * (std::abs(box.min[axis]) + std::abs(box.max[axis])) + 1e-9;
    if (p[axis] < box.min[axis] - margin || p[axis] > box.max[axis] + margin) return false;
  }
  return true;
}

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
          !near_box(other.surface, point)) {
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
  struct Context {
    const decltype(agrees)& test;
    const uint32_t* child;
    const uint32_t* bounded;
    bool agreed;
  } context{agrees, child, tree.bounded.data(), true};
  tree.bvh.visit_point(
      point,
      [](void* data, uint32_t item) {
        auto& c = *static_cast<Context*>(data);
        c.agreed = c.test(c.child[c.bounded[item]]);
        return !c.agreed;
      },
      &context);
  return context.agreed;
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
  ShapeRay local = local_ray(*this, node, ray);
  // The first hit may be clipped away.
  if (node.clips.count) local.csg_child = true;
  node.shape->hits(local, stack);
  if (node.clips.count == 0) return;
  size_t kept = base;
  for (size_t i = base; i < stack.size(); ++i) {
    if (inside_clips(node, ray.origin + stack[i].t * ray.direction)) stack[kept++] = stack[i];
  }
  stack.shrink(kept);
}

void Geometry::all_hits(uint32_t index, const GeometryRay& ray, HitStack& stack) const {
  const GeometryNode& node = nodes[index];
  if (node.kind == NodeKind::nothing) return;
  if (node.kind == NodeKind::shape) {
    shape_hits(index, ray, stack);
    return;
  }
  const bool direct = node.kind == NodeKind::union_ && node.clips.count == 0;
  Interval interval{0, kHugeDepth};
  if (node.surface_is_bounded) {
    interval = clip_to(node.surface, ray);
    if (!(interval.min <= interval.max)) return;
  }
  const auto visit = [&](uint32_t child) {
    const GeometryNode& member = nodes[child];
    if (!takes_part(node, member, ray.kind)) return;
    if (member.bounds.count && !passes_bounds(member, ray, stack)) return;
    const size_t base = stack.size();
    all_hits(child, ray, stack);
    if (direct) return;
    // Popped and pushed again: reversed within the child.
    for (size_t i = base, j = stack.size(); i + 1 < j; ++i) std::swap(stack[i], stack[--j]);
    size_t kept = base;
    for (size_t i = base; i < stack.size(); ++i) {
      // Farther out than the whole composite reaches: some other member rejects it.
      if (stack[i].t > interval.max || stack[i].t < interval.min) continue;
      if (keeps_hit(node, child, ray.origin + stack[i].t * ray.direction, ray.kind)) {
        stack[kept++] = stack[i];
      }
    }
    stack.shrink(kept);
  };
  const uint32_t* child = lists.data() + node.children.first;
  if (node.tree >= 0) {
    const ChildTree& tree = *trees[node.tree];
    ChildPicker picker;
    for (const uint32_t i : tree.others) picker.add(i);
    struct Context {
      ChildPicker& picker;
      const uint32_t* bounded;
    } context{picker, tree.bounded.data()};
    tree.bvh.visit_ray(
        ray.origin, ray.direction, interval.max,
        [](void* data, uint32_t item, double&) {
          auto& c = *static_cast<Context*>(data);
          c.picker.add(c.bounded[item]);
          return c.picker.overflowed();
        },
        &context);
    if (!picker.overflowed()) {
      picker.sort();
      for (const uint32_t i : picker) visit(child[i]);
      return;
    }
  }
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const GeometryNode& member = nodes[child[i]];
    if (member.surface_is_bounded) {
      const Interval reach = clip_to(member.surface, ray);
      if (!(reach.min <= reach.max) || reach.min > interval.max) continue;
    }
    visit(child[i]);
  }
}

bool Geometry::closest(uint32_t index, const GeometryRay& ray, double t_max, HitStack& stack,
                       ShapeHit& hit) const {
  const GeometryNode& node = nodes[index];
  if (node.kind == NodeKind::shape && node.clips.count == 0) {
    ShapeRay local = local_ray(*this, node, ray);
    local.t_max = t_max;
    if (!node.shape->closest(local, stack, hit)) return false;
    hit.node = index;
    return true;
  }
  if (node.kind == NodeKind::union_ && node.clips.count == 0) {
    // The nearest of the children; of equal ones the last.
    struct Context {
      const Geometry& geometry;
      const GeometryNode& node;
      const GeometryRay& ray;
      HitStack& stack;
      ShapeHit& hit;
      const uint32_t* bounded;
      double best;
      int64_t position;
      bool found;

      void test(uint32_t i) {
        const uint32_t child = geometry.lists[node.children.first + i];
        const GeometryNode& member = geometry.nodes[child];
        if (!geometry.takes_part(node, member, ray.kind)) return;
        if (member.bounds.count && !geometry.passes_bounds(member, ray, stack)) return;
        const double limit = found && i > position ? just_beyond(best) : best;
        ShapeHit candidate;
        if (!geometry.closest(child, ray, limit, stack, candidate)) return;
        hit = candidate;
        best = hit.t;
        position = i;
        found = true;
      }
    } context{*this, node, ray, stack, hit, nullptr, t_max, -1, false};
    if (node.tree >= 0) {
      const ChildTree& tree = *trees[node.tree];
      for (const uint32_t i : tree.others) context.test(i);
      context.bounded = tree.bounded.data();
      tree.bvh.visit_ray(
          ray.origin, ray.direction, context.best,
          [](void* data, uint32_t item, double& limit) {
            auto& c = *static_cast<Context*>(data);
            c.test(c.bounded[item]);
            limit = c.best;
            return false;
          },
          &context);
    } else {
      for (uint32_t i = 0; i < node.children.count; ++i) context.test(i);
    }
    return context.found;
  }
  const size_t base = stack.size();
  all_hits(index, ray, stack);
  bool found = false;
  double best = t_max;
  for (size_t i = stack.size(); i-- > base;) {
    if (stack[i].t < best && stack[i].t >= kLeastHitDepth) {
      best = stack[i].t;
      hit = stack[i];
      found = true;
    }
  }
  stack.shrink(base);
  return found;
}

void Geometry::finish_node(uint32_t index) {
  GeometryNode& node = nodes[index];
  node.surface = Bounds::everything();
  if (node.kind == NodeKind::shape) {
    Bounds box = node.shape->bounds();
    if (!box.is_empty() && box.is_bounded() && node.shape->is_solid_within_bounds()) {
      if (node.transform >= 0) box = transforms[node.transform].bounds(box);
      const Vec3 size = glm::max(glm::abs(box.min), glm::abs(box.max));
      const Vec3 margin = size * 1e-9 + Vec3(1e-12);
      node.surface = {box.min - margin, box.max + margin};
      node.surface_is_bounded = box.is_bounded();
      node.contains_outside = node.inverted;
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
    joined.extend(member.surface);
    if (member.contains_outside != is_intersection) outside = !is_intersection;
    if (is_intersection && !member.contains_outside) {
      common.clip(member.surface);
      has_common = true;
    }
  }
  if (is_intersection && has_common) {
    node.surface = common;
    node.surface_is_bounded = true;
    node.contains_outside = false;
    if (common.is_empty()) node.kind = NodeKind::nothing;
  } else if (all_bounded && !joined.is_empty()) {
    node.surface = joined;
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
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const GeometryNode& member = nodes[child[i]];
    if (member.kind == NodeKind::nothing && !member.has_object) continue;
    // Members that decide far from their surface are always asked.
    if (member.surface_is_bounded && member.contains_outside == is_intersection &&
        !member.surface.is_empty()) {
      tree->bounded.push_back(i);
      boxes.push_back(member.surface);
    } else {
      tree->others.push_back(i);
    }
  }
  if (boxes.empty()) return;
  tree->bvh.build(boxes);
  node.tree = static_cast<int32_t>(trees.size());
  trees.push_back(std::move(tree));
}

}  // namespace durer
