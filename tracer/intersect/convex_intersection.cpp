// One intersection or difference of convex solids and half spaces, the most usual CSG: a line's way
// through the solids is one interval, from which those that are cut out take theirs. No point is
// asked whether it lies inside, but where surfaces all but coincide. Where a crossing is missing
// the general way decides (geometry.cpp).
#include <algorithm>
#include <cmath>

#include "tracer/intersect/bvh_walk.h"
#include "tracer/intersect/convex_sweep.h"

namespace durer {
namespace {

// An end of an interval: where a line crosses a surface, or where the ray itself starts or ends.
struct Border {
  static constexpr uint32_t kEndOfRay = 0xffffffffu;

  double t;
  uint32_t node;
  uint32_t part;
  bool is_doubtful;  // another one, perhaps the true one, is as near

  static Border of_ray(double t) { return {t, kEndOfRay, 0, false}; }
  bool is_crossing() const { return node != kEndOfRay; }
};

struct Span {
  Border enter, leave;
};

double doubt_at(double t) { return kSweepDoubt * (1 + t); }

// Whether two crossings, the second at this depth, may be one.
bool are_near(const Border& a, const Border& b, double doubt) {
  return a.is_crossing() && b.is_crossing() && std::abs(a.t - b.t) <= doubt;
}

}  // namespace

// A line's way through an intersection, and what is cut out of it.
struct Geometry::IntersectionSpans {
  Span way;
  Span cut[kMostCuts];  // not set beyond their count: clearing costs as much as a solid
  int cuts;

  IntersectionSpans() {}
};

// One more solid; `met` where the search goes on.
[[gnu::always_inline]] inline Geometry::Sweep Geometry::narrow_spans(
    uint32_t index, bool look_at_box, const GeometryRay& ray, double t_max, HitStack& stack,
    IntersectionSpans& spans) const {
  auto& [way, cut, cuts] = spans;
  const GeometryNode& member = nodes[index];
  const double slack = 2 * doubt_at(way.leave.t);
  SweptSolid solid(*this, member, ray);
  solid.find_crossings(way.enter.t - slack, way.leave.t + slack, look_at_box, stack);
  const LineHits& met = solid.crossings;

  Span span{Border::of_ray(kSweepStart), Border::of_ray(t_max)};
  bool is_cut_out = member.inverted;
  bool is_met = true;
  if (member.is_half_space) {
    // What a half space leaves is one, too.
    const bool starts = solid.holds_start() != member.inverted;
    is_cut_out = false;
    if (met.count == 0 || met.t[0] <= kSweepStart) {
      is_met = starts;
    } else {
      (starts ? span.leave : span.enter) = {met.t[0], index, met.part[0], false};
    }
  } else if (met.count == 2) {
    const int first = met.t[1] < met.t[0];
    const int last = 1 - first;
    is_met = met.t[last] > kSweepStart;
    if (met.t[first] > kSweepStart) span.enter = {met.t[first], index, met.part[first], false};
    span.leave = {met.t[last], index, met.part[last], false};
  } else if (met.count == 1) {
    // Where the ray leaves, unless rounding took the other crossing.
    if (!(met.t[0] > kSweepStart) || !solid.holds_start()) return Sweep::doubtful;
    span.leave = {met.t[0], index, met.part[0], false};
  } else if (met.count == 0) {
    is_met = false;
  } else {
    return Sweep::doubtful;
  }

  if (is_cut_out) {
    if (!is_met) return Sweep::met;
    const double doubt = doubt_at(span.leave.t);
    if (span.leave.t < way.enter.t - doubt || span.enter.t > way.leave.t + doubt) {
      return Sweep::met;
    }
    if (span.enter.t < way.enter.t - doubt && span.leave.t > way.leave.t + doubt) {
      return Sweep::missed;
    }
    if (cuts == kMostCuts) return Sweep::doubtful;
    cut[cuts++] = span;
    return Sweep::met;
  }
  if (!is_met) return Sweep::missed;
  if (span.enter.is_crossing()) {
    const double doubt = doubt_at(span.enter.t);
    const bool is_later = span.enter.t > way.enter.t;
    const bool is_near = are_near(way.enter, span.enter, doubt);
    if (is_later) way.enter = span.enter;
    way.enter.is_doubtful |= is_near;
  }
  if (span.leave.is_crossing()) {
    const double doubt = doubt_at(span.leave.t);
    const bool is_sooner = span.leave.t < way.leave.t;
    const bool is_near = are_near(way.leave, span.leave, doubt);
    if (is_sooner) way.leave = span.leave;
    way.leave.is_doubtful |= is_near;
  }
  if (way.enter.t > way.leave.t + doubt_at(way.leave.t)) return Sweep::missed;
  return Sweep::met;
}

[[gnu::always_inline]] inline Geometry::Sweep Geometry::find_spans(const GeometryNode& node,
                                                                   const GeometryRay& ray,
                                                                   double t_max, HitStack& stack,
                                                                   IntersectionSpans& spans) const {
  spans.way = {Border::of_ray(kSweepStart), Border::of_ray(t_max)};
  spans.cuts = 0;
  for (uint32_t i = 0; i < node.swept.count; ++i) {
    // The first one's box has been met: hierarchies have no smaller one for the whole.
    const Sweep sweep = narrow_spans(lists[node.swept.first + i], i > 0, ray, t_max, stack, spans);
    if (sweep != Sweep::met) return sweep;
  }
  return node.tree < 0 ? Sweep::met : cut_out_tree(node, ray, t_max, stack, spans);
}

// The solids of the node's hierarchy: all are cut out.
[[gnu::noinline]] Geometry::Sweep Geometry::cut_out_tree(const GeometryNode& node,
                                                         const GeometryRay& ray, double t_max,
                                                         HitStack& stack,
                                                         IntersectionSpans& spans) const {
  const ChildTree& tree = *trees[node.tree];
  const uint32_t* child = lists.data() + node.children.first;
  const double leave = spans.way.leave.t;
  Sweep sweep = Sweep::met;
  tree.bvh.visit_ray<true>(
      ray, leave + 2 * doubt_at(leave), [&](uint32_t first, uint32_t count, double&) {
        for (uint32_t i = first; i < first + count && sweep == Sweep::met; ++i) {
          sweep = narrow_spans(child[tree.bounded[i]], true, ray, t_max, stack, spans);
        }
        return sweep != Sweep::met;
      });
  return sweep;
}

// Whether a point lies in all solids of a flat intersection but one, by their own tests.
bool Geometry::all_others_hold(const GeometryNode& node, uint32_t except, const Vec3& point) const {
  const uint32_t* solid = lists.data() + node.swept.first;
  for (uint32_t i = 0; i < node.swept.count; ++i) {
    if (solid[i] != except && !inside_unclipped(solid[i], point)) return false;
  }
  if (node.tree < 0) return true;
  const ChildTree& tree = *trees[node.tree];
  const uint32_t* child = lists.data() + node.children.first;
  bool held = true;
  tree.bvh.visit_point(point, [&](uint32_t position) {
    const uint32_t cut = child[tree.bounded[position]];
    held = cut == except || inside_unclipped(cut, point);
    return !held;
  });
  return held;
}

// In cases of doubt: the nearest crossing from just before a depth on that the tests of all other
// solids let stand, where none before it does.
[[gnu::noinline]] Geometry::Sweep Geometry::settle_sweep(const GeometryNode& node,
                                                         const GeometryRay& ray, double from,
                                                         double t_max,
                                                         const IntersectionSpans& spans,
                                                         HitStack& stack, ShapeHit& hit) const {
  constexpr size_t kMost = 2 * kMostCuts;
  Border border[kMost];
  size_t count = 0;
  const double start = std::max(from - 2 * doubt_at(from), kLeastHitDepth);
  const auto add = [&](const Border& one) {
    if (!one.is_crossing() || one.t < start || one.t >= t_max) return;
    if (count < kMost) border[count] = one;
    ++count;
  };
  for (int i = 0; i < spans.cuts; ++i) {
    add(spans.cut[i].enter);
    add(spans.cut[i].leave);
  }
  // Of the others only the ends of the way are known.
  const uint32_t* solid = lists.data() + node.swept.first;
  for (uint32_t i = 0; i < node.swept.count; ++i) {
    const GeometryNode& member = nodes[solid[i]];
    if (member.inverted && !member.is_half_space) continue;
    SweptSolid swept(*this, member, ray);
    swept.find_crossings(start, t_max, true, stack);
    const LineHits& met = swept.crossings;
    for (int k = 0; k < met.count; ++k) add({met.t[k], solid[i], met.part[k], false});
  }
  if (count > kMost) return Sweep::doubtful;

  std::sort(border, border + count, [](const Border& a, const Border& b) { return a.t < b.t; });
  for (size_t i = 0; i < count;) {
    const double t = border[i].t;
    const Vec3 point = ray.origin + t * ray.direction;
    int kept = 0;
    for (; i < count && border[i].t == t; ++i) {
      if (!all_others_hold(node, border[i].node, point)) continue;
      hit = {t, border[i].node, border[i].part, 0, 0};
      ++kept;
    }
    // Which of equal ones wins depends on their order.
    if (kept > 0) return kept == 1 ? Sweep::met : Sweep::doubtful;
  }
  return Sweep::missed;
}

Geometry::Sweep Geometry::sweep_convex_intersection(const GeometryNode& node,
                                                    const GeometryRay& ray, double t_max,
                                                    HitStack& stack, ShapeHit& hit) const {
  IntersectionSpans spans;
  const Sweep sweep = find_spans(node, ray, t_max, stack, spans);
  if (sweep != Sweep::met) return sweep;
  const auto& [way, cut, cuts] = spans;
  const auto settle_from = [&](double t) {
    return settle_sweep(node, ray, t, t_max, spans, stack, hit);
  };
  const auto end_at = [&](const Border& border) {
    if (border.is_doubtful) return settle_from(border.t);
    hit = {border.t, border.node, border.part, 0, 0};
    return Sweep::met;
  };
  Border at = way.enter;
  for (;;) {
    const double doubt = doubt_at(at.t);
    const auto is_near = [&](const Border& border) { return are_near(at, border, doubt); };
    // Out of what is cut out here.
    const Span* around = nullptr;
    for (int i = 0; i < cuts && !around; ++i) {
      if (cut[i].leave.node == at.node) continue;
      if (is_near(cut[i].enter) || is_near(cut[i].leave)) return settle_from(at.t);
      if (cut[i].enter.t <= at.t && at.t < cut[i].leave.t) around = &cut[i];
    }
    if (around) {
      at = around->leave;
      continue;
    }
    if (is_near(way.leave)) return settle_from(at.t);
    if (at.t >= way.leave.t) return Sweep::missed;
    if (at.is_crossing() && at.t >= kLeastHitDepth) return end_at(at);

    // The ray starts inside: where it leaves.
    Border end = way.leave;
    for (int i = 0; i < cuts; ++i) {
      const Border& enter = cut[i].enter;
      if (!(enter.t > at.t)) continue;
      const bool is_double = end.is_crossing() && std::abs(enter.t - end.t) <= doubt_at(end.t);
      if (enter.t < end.t) {
        end = enter;
        around = &cut[i];
      }
      end.is_doubtful |= is_double;
    }
    if (!end.is_crossing()) return Sweep::missed;
    if (end.t >= kLeastHitDepth || end.is_doubtful) return end_at(end);
    if (!around) return Sweep::missed;
    at = around->leave;
  }
}

Geometry::Sweep Geometry::sweep_all_of_intersection(const GeometryNode& node,
                                                    const GeometryRay& ray, double t_max,
                                                    HitStack& stack) const {
  IntersectionSpans spans;
  const Sweep sweep = find_spans(node, ray, t_max, stack, spans);
  if (sweep != Sweep::met) return sweep;
  const auto& [way, cut, cuts] = spans;
  // Pushes a border if it is one of the whole; false: that is doubtful.
  const auto push = [&](const Border& border, bool is_cut) {
    if (!border.is_crossing()) return true;
    const double doubt = doubt_at(border.t);
    if (border.is_doubtful) return false;
    if (is_cut) {
      if (are_near(border, way.enter, doubt) || are_near(border, way.leave, doubt)) return false;
      if (border.t < way.enter.t || border.t > way.leave.t) return true;
    }
    bool is_cut_off = false;
    for (int i = 0; i < cuts; ++i) {
      if (cut[i].leave.node == border.node) continue;
      if (are_near(border, cut[i].enter, doubt) || are_near(border, cut[i].leave, doubt)) {
        return false;
      }
      is_cut_off |= cut[i].enter.t <= border.t && border.t < cut[i].leave.t;
    }
    if (!is_cut_off) stack.push({border.t, border.node, border.part, 0, 0});
    return true;
  };
  if (way.enter.is_crossing() && are_near(way.enter, way.leave, doubt_at(way.leave.t))) {
    return Sweep::doubtful;
  }
  if (!push(way.enter, false) || !push(way.leave, false)) return Sweep::doubtful;
  for (int i = 0; i < cuts; ++i) {
    if (!push(cut[i].enter, true) || !push(cut[i].leave, true)) return Sweep::doubtful;
  }
  return Sweep::met;
}

}  // namespace durer
