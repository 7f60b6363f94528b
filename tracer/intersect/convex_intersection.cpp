// One intersection or difference of convex solids and half spaces, the most usual CSG: a line's way
// through the solids is one interval, from which those that are cut out take theirs. No point is asked
// whether it lies inside. Where surfaces all but coincide, or a crossing is missing, the general way
// decides (geometry.cpp).
#include <cmath>

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

}  // namespace

Geometry::Sweep Geometry::sweep_convex_intersection(const GeometryNode& node,
                                                    const GeometryRay& ray, double t_max,
                                                    HitStack& stack, ShapeHit& hit) const {
  Span way{Border::of_ray(kSweepStart), Border::of_ray(t_max)};
  Span cut[kMostCuts];  // not set beyond their count: clearing costs as much as a solid
  int cuts = 0;

  for (uint32_t i = 0; i < node.swept.count; ++i) {
    const uint32_t index = lists[node.swept.first + i];
    const GeometryNode& member = nodes[index];
    const double slack = 2 * doubt_at(way.leave.t);
    // The first one's box has been met: hierarchies have no smaller one for the whole.
    SweptSolid solid(*this, member, ray);
    solid.find_crossings(way.enter.t - slack, way.leave.t + slack, i > 0, stack);
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
      if (!is_met) continue;
      const double doubt = doubt_at(span.leave.t);
      if (span.leave.t < way.enter.t - doubt || span.enter.t > way.leave.t + doubt) continue;
      if (span.enter.t < way.enter.t - doubt && span.leave.t > way.leave.t + doubt) {
        return Sweep::missed;
      }
      if (cuts == kMostCuts) return Sweep::doubtful;
      cut[cuts++] = span;
      continue;
    }
    if (!is_met) return Sweep::missed;
    if (span.enter.is_crossing()) {
      const double doubt = doubt_at(span.enter.t);
      const bool is_later = span.enter.t > way.enter.t;
      const bool is_near = way.enter.is_crossing() && std::abs(span.enter.t - way.enter.t) <= doubt;
      if (is_later) way.enter = span.enter;
      way.enter.is_doubtful |= is_near;
    }
    if (span.leave.is_crossing()) {
      const double doubt = doubt_at(span.leave.t);
      const bool is_sooner = span.leave.t < way.leave.t;
      const bool is_near = way.leave.is_crossing() && std::abs(span.leave.t - way.leave.t) <= doubt;
      if (is_sooner) way.leave = span.leave;
      way.leave.is_doubtful |= is_near;
    }
    if (way.enter.t > way.leave.t + doubt_at(way.leave.t)) return Sweep::missed;
  }

  const auto end_at = [&](const Border& border) {
    if (border.is_doubtful) return Sweep::doubtful;
    hit = {border.t, border.node, border.part, 0, 0};
    return Sweep::met;
  };
  Border at = way.enter;
  for (;;) {
    const double doubt = doubt_at(at.t);
    const auto is_near = [&](const Border& border) {
      return at.is_crossing() && border.is_crossing() && std::abs(border.t - at.t) <= doubt;
    };
    // Out of what is cut out here.
    const Span* around = nullptr;
    for (int i = 0; i < cuts && !around; ++i) {
      if (cut[i].leave.node == at.node) continue;
      if (is_near(cut[i].enter) || is_near(cut[i].leave)) return Sweep::doubtful;
      if (cut[i].enter.t <= at.t && at.t < cut[i].leave.t) around = &cut[i];
    }
    if (around) {
      at = around->leave;
      continue;
    }
    if (is_near(way.leave)) return Sweep::doubtful;
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

}  // namespace durer
