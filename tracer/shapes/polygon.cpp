// polygon { n, <point>, … }                                          (spec/geometry.md 13.3)
#include <cmath>

#include "tracer/math/transform.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kSame = 1e-10;  // points this close, per coordinate, close a sub-polygon
constexpr double kThickness = 1e-3;

bool same_point(const Vec3& a, const Vec3& b) {
  return std::abs(a.x - b.x) < kSame && std::abs(a.y - b.y) < kSame && std::abs(a.z - b.z) < kSame;
}

// In its own plane z = 0, with the transforms in its frame.
class Polygon final : public Shape {
 public:
  Polygon(std::vector<Vec2> points, const Transform& frame)
      : points_(std::move(points)), frame_(frame) {}

  // Of the points where they are now.
  Bounds bounds() const override {
    Bounds box;
    for (const Vec2& p : points_) box.extend(frame_.point({p.x, p.y, 0}));
    for (int i = 0; i < 3; ++i) {
      // A box's lower corner and its edges are kept in single precision; what is flat grows after.
      const float edge = static_cast<float>(box.max[i] - box.min[i]);
      if (edge >= static_cast<float>(kThickness)) continue;
      box.min[i] = static_cast<double>(static_cast<float>(box.min[i])) - kThickness;
      box.max[i] = box.min[i] + (static_cast<double>(edge) + 2 * kThickness);
    }
    return box;
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    Vec3 d = frame_.inverse_direction(ray.direction);
    const double stretch = length(d);
    d *= 1 / stretch;
    if (std::abs(d.z) < kGeometryEpsilon) return;
    const Vec3 o = frame_.inverse_point(ray.origin);
    const double depth = -o.z / d.z;
    if (!(depth >= 1e-8 && depth <= kGreatestDepth)) return;
    if (covers(o.x + depth * d.x, o.y + depth * d.y)) out.push(depth / stretch);
  }

  bool inside(const Vec3&) const override { return false; }
  Vec3 normal(const Vec3&, const ShapeHit&) const override { return frame_.normal({0, 0, 1}); }
  bool takes_inverse_mark() const override { return false; }

  std::shared_ptr<const Shape> transformed(const Transform& transform) const override {
    return std::make_shared<Polygon>(points_, frame_.then(transform));
  }

 private:
  // Even-odd parity of all sub-polygons along +x.
  bool covers(double x, double y) const {
    bool inside = false;
    size_t first = 0;
    bool previous_above = points_[0].y >= y;
    for (size_t i = 1; i < points_.size();) {
      const Vec2 &from = points_[i - 1], &to = points_[i];
      const bool above = to.y >= y;
      if (above != previous_above) {
        const bool beyond = (to.y - y) * (from.x - to.x) >= (to.x - x) * (from.y - to.y);
        if (beyond == above) inside = !inside;
      }
      previous_above = above;
      ++i;
      if (to == points_[first] && i < points_.size()) {
        first = i;
        previous_above = points_[i].y >= y;
        ++i;
      }
    }
    return inside;
  }

  std::vector<Vec2> points_;  // closed sub-polygons one after another
  Transform frame_;           // from the plane z = 0
};

}  // namespace

PlacedShape compile(const PolygonNode& node, const ShapeContext&) {
  if (node.points.size() < 3) return {};
  // Close every sub-polygon exactly.
  std::vector<Vec3> points = node.points;
  size_t first = 0;
  for (size_t i = 1; i < points.size(); ++i) {
    if (same_point(points[i], points[first])) {
      points[i] = points[first];
      first = ++i;
    }
  }
  if (first < points.size()) points.push_back(points[first]);

  // The plane's frame from the first points that are not in line.
  const Vec3 origin = points[0];
  size_t i = 1;
  Vec3 u0(0), v0(0);
  for (; i < points.size(); ++i) {
    u0 = points[i] - origin;
    if (dot(u0, u0) > kGeometryEpsilon) break;
  }
  bool found = false;
  for (++i; i < points.size() && !found; ++i) {
    v0 = points[i] - origin;
    const Vec3 w = cross(u0, v0);
    found = dot(v0, v0) > kGeometryEpsilon && dot(w, w) > kGeometryEpsilon;
  }
  if (!found) return {};
  // Brought to unit length at last, and inverted by exchanging rows and columns, as povray does it: the
  // last digits show it where a pattern jumps in the polygon's plane.
  const Vec3 w0 = cross(u0, v0), u1 = cross(v0, w0), w = unit_or_zero(w0);
  Transform turn;
  turn.forward.row[0] = unit_or_zero(u1);
  turn.forward.row[1] = unit_or_zero(cross(w0, u1));
  turn.forward.row[2] = w;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      turn.inverse.row[row][column] = turn.forward.row[column][row];
  const Transform frame = turn.then(Transform::translation(origin));

  std::vector<Vec2> flat;
  for (const Vec3& p : points) {
    if (std::abs(dot(p - origin, w)) > kGeometryEpsilon) return {};
    const Vec3 local = frame.inverse_point(p);
    flat.push_back({local.x, local.y});
  }
  return {std::make_shared<Polygon>(std::move(flat), frame), false, {}};
}

}  // namespace durer
