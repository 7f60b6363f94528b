// Intersections and differences of few convex solids and half spaces, the most usual kind of CSG: one
// sweep along the ray over where it crosses the members' surfaces, without asking for points inside
// (performance.md 4). In doubtful cases, where surfaces coincide or a crossing is missing, the general
// way decides (geometry.cpp).
#include <cmath>

#include "tracer/intersect/geometry.h"

namespace durer {
namespace {

constexpr uint32_t kMostMembers = 8;
// Where on the ray the sweep starts: before all hits that count.
constexpr double kStart = 0.5 * kLeastHitDepth;
// Crossings of two members closer than this share of their depth are doubtful.
constexpr double kDoubt = 1e-7;

struct Crossing {
  double t;
  uint32_t member;    // bit
  uint32_t position;  // in the stack
};

// In the order of their depths.
class Crossings {
 public:
  void add(const Crossing& crossing) {
    int place = count_++;
    while (place > 0 && crossing_[place - 1].t > crossing.t) {
      crossing_[place] = crossing_[place - 1];
      --place;
    }
    crossing_[place] = crossing;
  }
  const Crossing* begin() const { return crossing_; }
  const Crossing* end() const { return crossing_ + count_; }

 private:
  Crossing crossing_[2 * kMostMembers];
  int count_ = 0;
};

}  // namespace

bool Geometry::is_of_convex_solids(const GeometryNode& node) const {
  if (node.kind != NodeKind::intersection || node.clips.count || node.tree >= 0 ||
      node.children.count > kMostMembers) {
    return false;
  }
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const GeometryNode& member = nodes[lists[node.children.first + i]];
    if (member.kind != NodeKind::shape || member.clips.count || member.bounds.count ||
        !(member.shape->is_convex_solid() || member.shape->is_half_space())) {
      return false;
    }
  }
  return true;
}

Geometry::Sweep Geometry::sweep_convex_solids(const GeometryNode& node, const GeometryRay& ray,
                                              double t_max, HitStack& stack, ShapeHit& hit) const {
  const uint32_t* child = lists.data() + node.children.first;
  const size_t base = stack.size();
  const auto give_back = [&](Sweep result) {
    stack.shrink(base);
    return result;
  };
  Crossings crossings;
  uint32_t outside = 0;  // members whose solids the sweep is not in
  for (uint32_t i = 0; i < node.children.count; ++i) {
    const GeometryNode& member = nodes[child[i]];
    const uint32_t bit = 1u << i;
    double low = kStart, high = t_max;
    if (member.is_boxed) ray.clip(member.reach, low, high);
    const size_t first = stack.size();
    if (low <= high * (1 + 1e-12)) {
      stack.owner = child[i];
      ShapeRay local = shape_ray(ray, member.transform < 0 ? nullptr : &transforms[member.transform]);
      local.csg_child = true;
      member.shape->hits(local, stack);
      stack.count_test(member.shape_kind, stack.size() > first);
    }
    const size_t count = stack.size() - first;
    // Where the sweep starts.
    const auto starts_inside = [&] {
      const Vec3 start = ray.origin + kStart * ray.direction;
      return member.shape->inside(member.transform < 0
                                      ? start
                                      : transforms[member.transform].inverse_point(start));
    };
    bool inside = false;
    if (member.narrows || member.shape->is_convex_solid()) {
      if (count > 2) return give_back(Sweep::doubtful);
      if (count == 2) {
        inside = (stack[first].t > kStart) != (stack[first + 1].t > kStart);
      } else if (count == 1) {
        // Where the ray leaves, unless rounding took the other crossing.
        inside = stack[first].t > kStart;
        if (!inside || !starts_inside()) return give_back(Sweep::doubtful);
      }
    } else {
      inside = starts_inside();
    }
    const bool in_solid = inside != member.inverted;
    if (!in_solid) {
      if (count == 0) return give_back(Sweep::missed);
      outside |= bit;
    }
    for (size_t k = first; k < stack.size(); ++k) {
      if (stack[k].t > kStart) crossings.add({stack[k].t, bit, static_cast<uint32_t>(k)});
    }
  }

  const Crossing* before = nullptr;
  for (const Crossing& crossing : crossings) {
    if (before && before->member != crossing.member &&
        crossing.t - before->t <= kDoubt * (1 + crossing.t)) {
      return give_back(Sweep::doubtful);
    }
    before = &crossing;
    // The surface shows where all the others contain it.
    const bool shows = (outside & ~crossing.member) == 0 && crossing.t >= kLeastHitDepth;
    if (shows && crossing.t >= t_max) return give_back(Sweep::missed);
    if (shows) {
      const Crossing* next = &crossing + 1;
      if (next != crossings.end() && next->member != crossing.member &&
          next->t - crossing.t <= kDoubt * (1 + crossing.t)) {
        return give_back(Sweep::doubtful);
      }
      hit = stack[crossing.position];
      return give_back(Sweep::met);
    }
    outside ^= crossing.member;
  }
  return give_back(Sweep::missed);
}

}  // namespace durer
