// cylinder { <base>, <apex>, radius [open] }                         (spec/geometry.md 12.3)
// cone { <base>, radius, <apex>, radius [open] }
//
// Local frame: z along the axis, z = 0 … 1; a cone's apex is the origin and its surface ρ = |z|.
#include <cmath>

#include "tracer/math/min_max.h"
#include "tracer/math/transform.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

enum Part : uint32_t { side, cap, base };

// Crossings of the side this near to a disc do not tell whether the disc is met.
constexpr double kRim = 1e-6;

// The frame that takes the unit solid to its place: z to the axis, scaled by (r, r, height).
PlacedShape place(std::shared_ptr<const Shape> shape, const Vec3& origin, const Vec3& unit_axis,
                  double radius, double height) {
  const Transform frame = Transform::scaling({radius, radius, height})
                              .then(Transform::rotation_from_z(unit_axis))
                              .then(Transform::translation(origin));
  return {std::move(shape), true, frame};
}

class Cone final : public Shape {
 public:
  Cone(bool is_cylinder, double least_z, bool closed)
      : is_cylinder_(is_cylinder), least_z_(least_z), closed_(closed) {}

  Bounds bounds() const override { return {{-1, -1, least_z_}, {1, 1, 1}}; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    LineHits met;
    line_hits(ray, met);
    met.push_to(out);
  }

  // In the order of the specification.
  void line_hits(const ShapeRay& ray, LineHits& out) const override {
    const double stretch = find(ray, out);
    for (int i = 0; i < out.count; ++i) out.t[i] /= stretch;
  }

  bool closest(const ShapeRay& ray, HitStack&, ShapeHit& hit) const override {
    LineHits met;
    const double stretch = find(ray, met);
    double best = ray.t_max;
    bool found = false;
    for (int i = met.count; i-- > 0;) {
      const double t = met.t[i] / stretch;
      if (t < best && t >= kLeastHitDepth) {
        best = t;
        hit.t = t;
        hit.part = met.part[i];
        found = true;
      }
    }
    return found;
  }

  bool inside(const Vec3& p) const override {
    const double margin = closed_ ? -kGeometryEpsilon : kGeometryEpsilon;
    const double radius2 = is_cylinder_ ? 1 : p.z * p.z;
    return !(p.x * p.x + p.y * p.y > radius2 + margin || p.z < least_z_ - margin ||
             p.z > 1 + margin);
  }

  bool is_convex_solid() const override { return closed_; }

  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override {
    switch (hit.part) {
      case base: return {0, 0, -1};
      case cap: return {0, 0, 1};
      default: return {p.x, p.y, is_cylinder_ ? 0 : -p.z};
    }
  }

 private:
  // Whether the line misses the side beyond doubt, and the discs with it: most rays end here, before a
  // root or a quotient is taken.
  bool passes_by(const Vec3& o, const Vec3& direction, double length2) const {
    const double outward = is_cylinder_ ? 0 : direction.z;
    const double a = direction.x * direction.x + direction.y * direction.y - outward * outward;
    const double b = o.x * direction.x + o.y * direction.y - o.z * outward;
    const double c = o.x * o.x + o.y * o.y - (is_cylinder_ ? 1 : o.z * o.z);
    const double b2 = b * b, ac = a * c;
    if (!(a > 2 * kGeometryEpsilon * length2)) return false;
    const double doubt = 1e-12 * (b2 + std::abs(ac));
    if (b2 - ac < -doubt) return true;
    if (!is_cylinder_) return false;
    // How far beyond the nearer end the middle of the way inside lies, times a, and half that way's
    // height, times a.
    const double beyond =
        std::abs((o.z - 0.5) * a - b * direction.z) - (0.5 + kRim * (1 + std::abs(o.z))) * a;
    return beyond > 0 && beyond * beyond > (b2 - ac + doubt) * direction.z * direction.z;
  }

  static void add(double t, Part which, LineHits& out) {
    if (t > 1e-9 && t < kGreatestDepth) out.add(t, which);
  }

  // Where a line crosses the plane of a disc, and how far from the axis.
  struct DiscCrossing {
    DiscCrossing(const Vec3& o, const Vec3& d, double z) : t((z - o.z) / d.z) {
      const double x = o.x + t * d.x, y = o.y + t * d.y;
      radius2 = x * x + y * y;
    }
    double t, radius2;
  };

  // Whether a line crosses both discs of a cylinder beyond doubt, and so not its side; adds them.
  static bool goes_through_discs(const Vec3& o, const Vec3& d, double radius2, LineHits& out) {
    const DiscCrossing at_cap(o, d, 1), at_base(o, d, 0);
    if (!((at_cap.radius2 < radius2) & (at_base.radius2 < radius2))) return false;
    add(at_cap.t, cap, out);
    add(at_base.t, base, out);
    return true;
  }

  // Depths in normalised local space; returns how many times those in the world they are. (Each
  // quotient by itself: trace() gives povray's last digits.)
  double find(const ShapeRay& ray, LineHits& out) const {
    const Vec3& o = ray.origin;
    const double length2 = dot(ray.direction, ray.direction);
    if (passes_by(o, ray.direction, length2)) return 1;
    const double stretch = std::sqrt(length2);
    const Vec3 d = ray.direction * (1 / stretch);
    const auto add_side = [&](double t) {
      const double z = o.z + t * d.z;
      if (z >= least_z_ && z <= 1) add(t, side, out);
      return z;
    };
    // Both crossings of a side that the line is inside of between them. Returns whether it may meet
    // the discs, too: not on a way from side to side, nor on one beyond an end.
    const auto add_sides = [&](double first, double second) {
      const double z1 = add_side(first), z2 = add_side(second);
      const double low = smaller_of(z1, z2), high = larger_of(z1, z2);
      const bool misses = (low > 1 + kRim) | (high < least_z_ - kRim);
      const bool within = (low >= least_z_ + kRim) & (high <= 1 - kRim);
      return !(misses | within);
    };
    if (is_cylinder_) {
      const double a = d.x * d.x + d.y * d.y;
      const double c = o.x * o.x + o.y * o.y - 1;
      // Steep lines mostly go from disc to disc.
      if (closed_ && d.z * d.z > a && goes_through_discs(o, d, 1 - kRim - 1e-12 * std::abs(c), out)) {
        return stretch;
      }
      if (a > kGeometryEpsilon) {
        const double b = o.x * d.x + o.y * d.y;
        const double discriminant = b * b - a * c;
        // A line that passes by the side passes by the discs, too.
        if (discriminant < 0) return 1;
        const double root = std::sqrt(discriminant);
        if (!add_sides((-b + root) / a, (-b - root) / a)) return stretch;
      }
    } else {
      const double a = d.x * d.x + d.y * d.y - d.z * d.z;
      const double b = o.x * d.x + o.y * d.y - o.z * d.z;
      const double c = o.x * o.x + o.y * o.y - o.z * o.z;
      if (std::abs(a) < kGeometryEpsilon) {
        if (std::abs(b) > kGeometryEpsilon) add_side(-0.5 * c / b);
      } else {
        const double discriminant = b * b - a * c;
        if (discriminant >= 0) {
          const double root = std::sqrt(discriminant);
          const bool meets_discs = add_sides((-b - root) / a, (-b + root) / a);
          if (a > 0 && !meets_discs) return stretch;
        } else if (a > 0) {
          return 1;
        }
      }
    }
    if (closed_ && std::abs(d.z) > kGeometryEpsilon) {
      const auto add_disc = [&](double z, double radius2, Part which) {
        const DiscCrossing met(o, d, z);
        if (met.radius2 <= radius2) add(met.t, which, out);
      };
      add_disc(1, 1, cap);
      add_disc(least_z_, is_cylinder_ ? 1 : least_z_ * least_z_, base);
    }
    return stretch;
  }

  bool is_cylinder_;
  double least_z_;
  bool closed_;
};

// All cylinders are one of two in their own space: rays find it in the processor's cache.
const std::shared_ptr<const Shape>& unit_cylinder(bool closed) {
  static const std::shared_ptr<const Shape> closed_one = std::make_shared<Cone>(true, 0, true);
  static const std::shared_ptr<const Shape> open_one = std::make_shared<Cone>(true, 0, false);
  return closed ? closed_one : open_one;
}

}  // namespace

PlacedShape compile(const CylinderNode& node, const ShapeContext&) {
  const Vec3 axis = node.base - node.apex;
  const double height = length(axis);
  if (!(height >= kGeometryEpsilon)) return {};
  return place(unit_cylinder(!node.open), node.apex, axis * (1 / height), node.radius, height);
}

PlacedShape compile(const ConeNode& node, const ShapeContext& context) {
  if (std::abs(node.base_radius - node.apex_radius) < kGeometryEpsilon) {
    // Near enough a cylinder; its frame starts at the same end.
    return compile(CylinderNode{node.apex, node.base, node.base_radius, node.open}, context);
  }
  // The wider end is the top; the narrower one lies towards the apex of the full cone.
  const bool swap = node.base_radius < node.apex_radius;
  const Vec3 wide = swap ? node.apex : node.base, narrow = swap ? node.base : node.apex;
  const double wide_radius = swap ? node.apex_radius : node.base_radius;
  const double narrow_radius = swap ? node.base_radius : node.apex_radius;
  const Vec3 axis = wide - narrow;
  const double height = length(axis);
  if (!(height >= kGeometryEpsilon)) return {};
  const Vec3 unit_axis = axis * (1 / height);
  const double below = narrow_radius * height / (wide_radius - narrow_radius);
  const double full_height = below + height;
  // Also where both radii are negative: a cylinder of the narrower one.
  if ((wide_radius - narrow_radius) * height / full_height < kGeometryEpsilon) {
    return compile(CylinderNode{wide, narrow, wide_radius, node.open}, context);
  }
  return place(std::make_shared<Cone>(false, below / full_height, !node.open),
               narrow - below * unit_axis, unit_axis, wide_radius, full_height);
}

}  // namespace durer
