// quadric { <A,E,H>, <B,C,F>, <D,G,I>, J }                           (spec/geometry.md 14.2)
//
// A x² + E y² + H z² + B xy + C xz + F yz + D x + G y + I z + J = 0. Transforms go into the
// coefficients.
#include "tracer/shapes/quadric.h"

#include <algorithm>
#include <cmath>

#include "tracer/math/transform.h"

namespace durer {
namespace {

bool counts(double t) { return t > 1e-6 && t < kGreatestDepth; }

double largest_of(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

Quadric::Quadric(const QuadricNode& coefficients)
    : q_(coefficients),
      open_limit_(1e-9 * std::max(largest_of(q_.square), largest_of(q_.mixed))),
      form_sign_(has_form_of_sign(1) ? 1 : has_form_of_sign(-1) ? -1 : 0) {}

double Quadric::second_order(const Vec3& d) const {
  const Vec3 &s = q_.square, &m = q_.mixed;
  return d.x * (s.x * d.x + m.x * d.y + m.y * d.z) + d.y * (s.y * d.y + m.z * d.z) +
         d.z * s.z * d.z;
}

// Whether second_order() has this sign, or is about 0, for all directions: no principal minor of its
// matrix has another.
bool Quadric::has_form_of_sign(double sign) const {
  const Vec3 s = sign * q_.square, half = 0.5 * sign * q_.mixed;
  const double scale = largest_of(s);
  const double least = -1e-10 * scale;
  const double xy = s.x * s.y - half.x * half.x, xz = s.x * s.z - half.y * half.y,
               yz = s.y * s.z - half.z * half.z;
  const double all = s.x * yz - half.x * (half.x * s.z - half.z * half.y) +
                     half.y * (half.x * half.z - s.y * half.y);
  return scale > 0 && s.x >= least && s.y >= least && s.z >= least && xy >= least * scale &&
         xz >= least * scale && yz >= least * scale && all >= least * scale * scale;
}

int Quadric::depths(const ShapeRay& ray, double* t) const {
  const Vec3 &d = ray.direction, &o = ray.origin;
  const Vec3 &s = q_.square, &m = q_.mixed, &l = q_.linear;
  const double a = second_order(d);
  // In povray's order, to the last bit, which decides where quadrics coincide (measured on povray
  // 3.7).
  const double b = d.x * (s.x * o.x + 0.5 * (m.x * o.y + m.y * o.z + l.x)) +
                   d.y * (s.y * o.y + 0.5 * (m.x * o.x + m.z * o.z + l.y)) +
                   d.z * (s.z * o.z + 0.5 * (m.y * o.x + m.z * o.y + l.z));
  const double c = o.x * (s.x * o.x + m.x * o.y + m.y * o.z + l.x) +
                   o.y * (s.y * o.y + m.z * o.z + l.y) + o.z * (s.z * o.z + l.z) + q_.constant;
  if (a == 0) {
    if (b == 0) return 0;
    t[0] = -0.5 * c / b;
    return 1;
  }
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0)) return 0;
  const double root = std::sqrt(discriminant);
  t[0] = (-b + root) / a;
  t[1] = (-b - root) / a;
  return 2;
}

void Quadric::hits(const ShapeRay& ray, HitStack& out) const {
  double t[2];
  const int count = depths(ray, t);
  for (int i = 0; i < count; ++i) {
    if (counts(t[i])) out.push(t[i]);
  }
}

void Quadric::line_hits(const ShapeRay& ray, LineHits& out) const {
  double t[2];
  const int count = depths(ray, t);
  for (int i = 0; i < count; ++i) {
    if (counts(t[i])) out.add(t[i]);
  }
  // A line along an open end may lie within for ever; so may one whose ends are out of reach.
  const bool is_open = !(std::abs(second_order(ray.direction)) >
                         open_limit_ * dot(ray.direction, ray.direction));
  const bool is_within = count == 2 && out.count == 0 && (t[0] < 1) != (t[1] < 1);
  if (is_open || is_within) out.count = 3;
}

bool Quadric::closest(const ShapeRay& ray, HitStack&, ShapeHit& hit) const {
  double t[2];
  double best = ray.t_max;
  for (int i = depths(ray, t); i-- > 0;) {
    if (t[i] >= kLeastHitDepth && t[i] < kGreatestDepth && t[i] < best) best = t[i];
  }
  if (best >= ray.t_max) return false;
  hit.t = best;
  hit.part = 0;
  return true;
}

bool Quadric::inside(const Vec3& p) const {
  const Vec3 &s = q_.square, &m = q_.mixed, &l = q_.linear;
  return p.x * (s.x * p.x + m.x * p.y + m.y * p.z + l.x) + p.y * (s.y * p.y + m.z * p.z + l.y) +
             p.z * (s.z * p.z + l.z) + q_.constant <=
         0;
}

Vec3 Quadric::normal(const Vec3& p, const ShapeHit&) const {
  const Vec3 &s = q_.square, &m = q_.mixed, &l = q_.linear;
  const Vec3 n(2 * s.x * p.x + m.x * p.y + m.y * p.z + l.x,
               m.x * p.x + 2 * s.y * p.y + m.z * p.z + l.y,
               m.y * p.x + m.z * p.y + 2 * s.z * p.z + l.z);
  return n == Vec3(0) ? Vec3(1, 0, 0) : n;
}

std::shared_ptr<const Shape> Quadric::transformed(const Transform& transform) const {
  // Substitute p = p'·M⁻¹ into the form: Q' = M⁻¹ Q M⁻ᵀ, with Q upper triangular: so all sums are
  // povray's to the last bit.
  double q[4][4] = {{q_.square.x, q_.mixed.x, q_.mixed.y, q_.linear.x},
                    {0, q_.square.y, q_.mixed.z, q_.linear.y},
                    {0, 0, q_.square.z, q_.linear.z},
                    {0, 0, 0, q_.constant}};
  double m[4][4];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] = transform.inverse.row[i][j];
    m[i][3] = i == 3 ? 1 : 0;
  }
  double mq[4][4], r[4][4];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      mq[i][j] = 0;
      for (int k = 0; k < 4; ++k) mq[i][j] += m[i][k] * q[k][j];
    }
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      r[i][j] = 0;
      for (int k = 0; k < 4; ++k) r[i][j] += mq[i][k] * m[j][k];
    }
  }
  QuadricNode moved;
  moved.square = {r[0][0], r[1][1], r[2][2]};
  moved.mixed = {r[0][1] + r[1][0], r[0][2] + r[2][0], r[1][2] + r[2][1]};
  moved.linear = {r[0][3] + r[3][0], r[1][3] + r[3][1], r[2][3] + r[3][2]};
  moved.constant = r[3][3];
  return std::make_shared<Quadric>(moved);
}

std::shared_ptr<const Shape> Quadric::inverted() const {
  return std::make_shared<Quadric>(
      QuadricNode{-q_.square, -q_.mixed, -q_.linear, -q_.constant});
}

bool Quadric::has_automatic_bounds() const {
  if (is_aslant()) return false;
  const Vec3& s = q_.square;
  int plus = 0, minus = 0;
  double constant = -q_.constant;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(s[i]) < kGeometryEpsilon) continue;
    ++(s[i] > 0 ? plus : minus);
    constant += q_.linear[i] * q_.linear[i] / (4 * s[i]);
  }
  if (plus + minus < 3 || plus == 0 || minus == 0) return true;
  // Of cones and hyperboloids only those of two sheets: one sign of the squares is the constant's alone.
  return constant != 0 && (constant > 0 ? plus : minus) == 1;
}

bool Quadric::is_aslant() const {
  return std::abs(q_.mixed.x) >= kGeometryEpsilon || std::abs(q_.mixed.y) >= kGeometryEpsilon ||
         std::abs(q_.mixed.z) >= kGeometryEpsilon;
}

// Measured on povray 3.7, mistakes included: pictures show what these boxes cut off.
bool Quadric::bounds_within(const Bounds& range, Bounds& box) const {
  if (is_aslant()) return false;
  // s.x (x-c.x)² + s.y (y-c.y)² + s.z (z-c.z)² + linear = rhs, linear terms left where s is 0.
  Vec3 s = q_.square, center(0), linear(0);
  double rhs = -q_.constant, shift = 0;
  int plus = 0, minus = 0;
  int odd = 0;  // the axis along which the others' extents depend on the range
  for (int i = 0; i < 3; ++i) {
    if (std::abs(s[i]) < kGeometryEpsilon) {
      s[i] = 0;
      odd = i;
      linear[i] = std::abs(q_.linear[i]) < kGeometryEpsilon ? 0 : q_.linear[i];
      continue;
    }
    ++(s[i] > 0 ? plus : minus);
    center[i] = -q_.linear[i] / (2 * s[i]);
    shift += s[i] * center[i] * center[i];
  }
  rhs += shift;
  const bool turned = minus > plus;
  if (turned) {
    s = -s;
    linear = -linear;
    rhs = -rhs;
    shift = -shift;
    std::swap(plus, minus);
  }
  box = Bounds::everything();
  box.clip(range);
  double most;  // of s.x (x-c.x)² and of the same along each other axis
  if (plus == 3 && rhs > 0) {
    most = rhs;
  } else if (plus == 2 && minus == 1 && rhs >= 0) {
    // Cones, and hyperboloids as if they were of 1.
    for (int i = 0; i < 3; ++i) odd = s[i] < 0 ? i : odd;
    const double reach =
        std::max(std::abs(range.min[odd] - center[odd]), std::abs(range.max[odd] - center[odd]));
    most = (rhs > 0 ? 1 : 0) - s[odd] * reach * reach;
  } else if (plus == 2 && minus == 0 && !(turned && odd == 0)) {
    if (linear[odd] == 0) {
      if (!(rhs > 0)) return false;
      most = rhs;
    } else if (center != Vec3(0)) {
      // Paraboloids away from their axis, as if they were cylinders.
      most = shift;
    } else {
      // Their vertex is taken for its mirror image.
      const double vertex = -rhs / linear[odd];
      double end;
      if (linear[odd] > 0) {
        box.max[odd] = std::min(box.max[odd], vertex);
        end = box.min[odd];
      } else {
        box.min[odd] = std::max(box.min[odd], vertex);
        end = box.max[odd];
      }
      most = std::abs(linear[odd] * (end - vertex));
    }
  } else {
    return false;
  }
  for (int i = 0; i < 3; ++i) {
    if (!(s[i] > 0)) continue;
    const double extent = std::sqrt(most / s[i]);
    box.min[i] = std::max(box.min[i], center[i] - extent);
    box.max[i] = std::min(box.max[i], center[i] + extent);
  }
  return true;
}

PlacedShape compile(const QuadricNode& node, const ShapeContext&) {
  return {std::make_shared<Quadric>(node), false, {}};
}

}  // namespace durer
