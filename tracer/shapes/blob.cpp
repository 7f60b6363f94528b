// blob { threshold … sphere … cylinder … }: a level of a sum of fields      (spec/geometry.md 12.7)
#include <algorithm>
#include <cmath>

#include "tracer/math/polynomial.h"
#include "tracer/math/transform.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kLeastDepth = 1e-2;
constexpr double kInsideTolerance = 1e-6;
constexpr double kRootElimination = 1e-11;
constexpr int kMostParts = 256;  // on one ray; more go to the heap

// A piece of a component whose field is a polynomial along a ray inside its support:
// strength (1 - d^2/R^2)^2 = c0 d^4 + c1 d^2 + c2, d the distance to the skeleton.
struct Part {
  enum class Kind : uint8_t { ball, tube, base_cap, apex_cap };
  Kind kind = Kind::ball;
  bool has_transform = false;
  int texture = -1;  // index; -1: the blob's
  Vec3 center{0};    // ball: its centre; other kinds: the origin of their frame
  double radius2 = 1, length = 0;
  double c0 = 0, c1 = 0, c2 = 0;
  Transform frame;  // part space to blob space
  Bounds box;       // of the support, in blob space

  Vec3 local(const Vec3& p) const { return has_transform ? frame.inverse_point(p) : p; }
  // Offset from the skeleton, in part space; false outside this kind's slab.
  bool offset(const Vec3& at, Vec3& q) const {
    switch (kind) {
      case Kind::ball: q = at - center; return true;
      case Kind::tube: q = Vec3(at.x, at.y, 0); return at.z >= 0 && at.z <= length;
      case Kind::base_cap: q = at; return at.z <= 0;
      case Kind::apex_cap: q = at - Vec3(0, 0, length); return at.z >= 0 && q.z >= 0;
    }
    return false;
  }
  double field(const Vec3& p) const {
    Vec3 q;
    if (!offset(local(p), q)) return 0;
    const double d2 = dot(q, q);
    return d2 <= radius2 ? (c0 * d2 + c1) * d2 + c2 : 0;
  }
};

// Where a ray is inside a part's support, and d^2 = a t^2 + b t + c there.
struct Span {
  double from, to;
  double a, b, c;
  const Part* part;
};

// A small hierarchy over the parts' supports.
struct Node {
  Bounds box;
  int first = 0, count = 0;  // parts of a leaf
  int left = -1, right = -1;
};

class Blob final : public Shape {
 public:
  explicit Blob(const BlobNode& node) : threshold_(node.threshold), sturm_(node.sturm) {
    const bool own = std::any_of(node.components.begin(), node.components.end(),
                                 [](const BlobComponent& c) { return c.texture != nullptr; });
    has_textures_ = own;
    all_textured_ = std::all_of(node.components.begin(), node.components.end(),
                                [](const BlobComponent& c) { return c.texture != nullptr; });
    // The last component comes first.
    for (auto c = node.components.rbegin(); c != node.components.rend(); ++c) add(*c);
    order_.resize(parts_.size());
    for (size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<int>(i);
    if (!parts_.empty()) build(0, static_cast<int>(order_.size()));
  }

  Bounds bounds() const override { return box_; }
  bool ignores_interior_texture() const override { return has_textures_; }
  bool needs_object_texture() const override { return !all_textured_; }
  const std::vector<TexturePtr>* own_textures() const override {
    return has_textures_ ? &textures_ : nullptr;
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double scale = 1 / length(ray.direction);
    const Vec3 d = ray.direction * scale;
    Span few[kMostParts];
    std::vector<Span> many;
    int count = collect(ray.origin, d, few, kMostParts);
    Span* spans = few;
    if (count > kMostParts) {
      many.resize(static_cast<size_t>(count));
      spans = many.data();
      count = collect(ray.origin, d, spans, count);
    }
    if (count > 0) solve(spans, count, scale, ray.csg_child, out);
  }

  bool inside(const Vec3& p) const override {
    return field(p) > threshold_ - kInsideTolerance;
  }

  Vec3 normal(const Vec3& p, const ShapeHit&) const override {
    Vec3 sum(0);
    for_parts_at(p, [&](const Part& part) {
      Vec3 q;
      if (!part.offset(part.local(p), q)) return;
      const double d2 = dot(q, q);
      if (d2 > part.radius2) return;
      Vec3 n = (-2 * part.c0 * d2 - part.c1) * q;
      if (part.has_transform) n = part.frame.normal(n);
      sum += n;
    });
    return sum == Vec3(0) ? Vec3(1, 0, 0) : sum;
  }

  int texture_shares(const Vec3& p, const ShapeHit&, ShapeTexture* shares,
                     int capacity) const override {
    if (!has_textures_) {
      shares[0] = {-1, 1.0f};
      return 1;
    }
    int count = 0;
    double total = 0;
    for_parts_at(p, [&](const Part& part) {
      const double weight = std::abs(part.field(p));
      if (weight == 0) return;
      total += weight;
      // Each component is a share of its own, as small ones are left out one by one.
      if (count < capacity) {
        shares[count++] = {part.texture, static_cast<float>(weight)};
        return;
      }
      for (int i = 0; i < count; ++i) {
        if (shares[i].index == part.texture) {
          shares[i].weight += static_cast<float>(weight);
          return;
        }
      }
    });
    if (count == 0) {
      shares[0] = {-1, 1.0f};
      return 1;
    }
    for (int i = 0; i < count; ++i)
      shares[i].weight = static_cast<float>(static_cast<double>(shares[i].weight) / total);
    return count;
  }

 private:
  void add(const BlobComponent& c) {
    Part part;
    if (c.texture) {
      auto known = std::find(textures_.begin(), textures_.end(), c.texture);
      part.texture = static_cast<int>(known - textures_.begin());
      if (known == textures_.end()) textures_.push_back(c.texture);
    }
    part.radius2 = c.radius * c.radius;
    part.c0 = c.strength / (part.radius2 * part.radius2);
    part.c1 = -2 * c.strength / part.radius2;
    part.c2 = c.strength;
    const double r = std::abs(c.radius);
    const bool moved = !c.transform.is_identity();
    const bool enlarges = c.strength > 0;
    if (!c.is_cylinder) {
      part.center = c.center;
      part.has_transform = moved;
      part.frame = c.transform;
      push(part, part.center - Vec3(r), part.center + Vec3(r));
      if (enlarges) extend(part.center, r, moved, c.transform);
      return;
    }
    const Vec3 axis = c.apex - c.center;
    part.length = length(axis);
    const Transform placed =
        Transform::rotation_from_z(axis / part.length).then(Transform::translation(c.center));
    part.frame = moved ? placed.then(c.transform) : placed;
    part.has_transform = true;
    if (enlarges) {
      const double half = 0.5 * part.length;
      extend(Vec3(0, 0, half), std::sqrt(part.radius2 + half * half), true, part.frame);
      extend(Vec3(0), r, true, part.frame);
      extend(Vec3(0, 0, part.length), r, true, part.frame);
    }
    part.kind = Part::Kind::apex_cap;
    push(part, Vec3(-r, -r, part.length), Vec3(r, r, part.length + r));
    part.kind = Part::Kind::base_cap;
    push(part, Vec3(-r, -r, -r), Vec3(r, r, 0));
    part.kind = Part::Kind::tube;
    push(part, Vec3(-r, -r, 0), Vec3(r, r, part.length));
  }

  void push(Part& part, const Vec3& low, const Vec3& high) {
    const Bounds local{low, high};
    part.box = part.has_transform ? part.frame.bounds(local) : local;
    parts_.push_back(part);
  }

  // The reported box: spheres about the parts, the moved ones by the largest edge of a moved cube.
  void extend(const Vec3& center, double radius, bool moved, const Transform& transform) {
    Vec3 at = center;
    if (moved) {
      at = transform.point(center);
      // Of single precision, as all boxes of POV-Ray.
      const double edge = static_cast<double>(static_cast<float>(radius));
      const Bounds cube = transform.bounds({Vec3(0), Vec3(edge)});
      const Vec3 edges = cube.max - cube.min;
      radius = static_cast<double>(static_cast<float>(std::max({edges.x, edges.y, edges.z})));
    }
    box_.extend(at - Vec3(radius));
    box_.extend(at + Vec3(radius));
  }

  int build(int first, int count) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    Bounds box, centers;
    for (int i = first; i < first + count; ++i) {
      const Bounds& b = part_at(i).box;
      box.extend(b);
      centers.extend(0.5 * (b.min + b.max));
    }
    constexpr int kLeafSize = 2;
    int left = -1, right = -1;
    if (count > kLeafSize) {
      const Vec3 extent = centers.max - centers.min;
      const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
      const int half = count / 2;
      std::nth_element(order_.begin() + first, order_.begin() + first + half,
                       order_.begin() + first + count, [&](int a, int b) {
                         const Bounds &p = parts_[static_cast<size_t>(a)].box,
                                      &q = parts_[static_cast<size_t>(b)].box;
                         const double x = p.min[axis] + p.max[axis], y = q.min[axis] + q.max[axis];
                         return x < y || (x == y && a < b);
                       });
      left = build(first, half);
      right = build(first + half, count - half);
    }
    nodes_[static_cast<size_t>(index)] = {box, first, count, left, right};
    return index;
  }

  const Part& part_at(int i) const {
    return parts_[static_cast<size_t>(order_[static_cast<size_t>(i)])];
  }

  static bool crosses(const Bounds& box, const Vec3& o, const Vec3& d) {
    double from = 0, to = kHugeDepth;
    for (int i = 0; i < 3; ++i) {
      const double margin = 1e-9 * (1 + std::abs(box.min[i]) + std::abs(box.max[i]));
      const double low = box.min[i] - margin, high = box.max[i] + margin;
      if (d[i] == 0) {
        if (o[i] < low || o[i] > high) return false;
        continue;
      }
      const double a = (low - o[i]) / d[i], b = (high - o[i]) / d[i];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return from <= to;
  }

  // Spans of all parts that the ray crosses; returns how many there are, and stores what fits.
  int collect(const Vec3& o, const Vec3& d, Span* spans, int capacity) const {
    int count = 0;
    int stack[64], depth = 0;
    if (nodes_.empty()) return 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[static_cast<size_t>(stack[--depth])];
      if (!crosses(node.box, o, d)) continue;
      if (node.left >= 0) {
        stack[depth++] = node.right;
        stack[depth++] = node.left;
        continue;
      }
      for (int i = node.first; i < node.first + node.count; ++i) {
        Span span;
        if (!span_of(part_at(i), o, d, span)) continue;
        if (count < capacity) spans[count] = span;
        ++count;
      }
    }
    return count;
  }

  static bool span_of(const Part& part, const Vec3& o, const Vec3& d, Span& span) {
    Vec3 p = o, v = d;
    if (part.has_transform) {
      p = part.frame.inverse_point(o);
      v = part.frame.inverse_direction(d);
    }
    Vec3 q = p, w = v;
    if (part.kind == Part::Kind::ball) {
      q = p - part.center;
    } else if (part.kind == Part::Kind::tube) {
      q.z = w.z = 0;
    } else if (part.kind == Part::Kind::apex_cap) {
      q.z -= part.length;
    }
    const double a = dot(w, w), b = 2 * dot(q, w), c = dot(q, q);
    double from, to;
    if (part.kind == Part::Kind::tube && a < kGeometryEpsilon) {
      if (c > part.radius2) return false;
      from = -kHugeDepth;
      to = kHugeDepth;
    } else {
      const double half_b = 0.5 * b;
      const double discriminant = half_b * half_b - a * (c - part.radius2);
      if (discriminant < kGeometryEpsilon) return false;
      const double root = std::sqrt(discriminant);
      from = (-half_b - root) / a;
      to = (-half_b + root) / a;
    }
    // The slab of this kind.
    if (part.kind != Part::Kind::ball) {
      const double low = part.kind == Part::Kind::tube ? 0
                         : part.kind == Part::Kind::apex_cap ? part.length
                                                             : -kHugeDepth;
      const double high = part.kind == Part::Kind::tube ? part.length
                          : part.kind == Part::Kind::apex_cap ? kHugeDepth
                                                              : 0;
      if (std::abs(v.z) < kGeometryEpsilon) {
        if (p.z < low || p.z > high) return false;
      } else {
        const double s = (low - p.z) / v.z, e = (high - p.z) / v.z;
        from = std::max(from, std::min(s, e));
        to = std::min(to, std::max(s, e));
      }
    }
    if (to < kLeastDepth) return false;
    if (from < kLeastDepth) from = 0;
    if (!(from < to)) return false;
    span = {from, to, a, b, c, &part};
    return true;
  }

  // Between two boundaries the same parts add up to one quartic.
  void solve(Span* spans, int count, double scale, bool all, HitStack& out) const {
    double few[2 * kMostParts];
    std::vector<double> many;
    double* edges = few;
    if (count > kMostParts) {
      many.resize(static_cast<size_t>(2 * count));
      edges = many.data();
    }
    for (int i = 0; i < count; ++i) {
      edges[2 * i] = spans[i].from;
      edges[2 * i + 1] = spans[i].to;
    }
    std::sort(edges, edges + 2 * count);
    // The origin moves to the first edge and the last one becomes 1: better conditioned.
    const double start = edges[0] >= 1e-3 ? edges[0] : 0;
    const double end = edges[2 * count - 1], size = end - start;
    if (!(size > 0)) return;
    for (int i = 0; i < count; ++i) {
      Span& s = spans[i];
      s.c += start * (s.b + start * s.a);
      s.b = (s.b + 2 * start * s.a) * size;
      s.a *= size * size;
      s.from = (s.from - start) / size;
      s.to = (s.to - start) / size;
    }
    double previous = (edges[0] - start) / size;
    for (int i = 1; i < 2 * count; ++i) {
      const double next = (edges[i] - start) / size;
      if (next - previous < kGeometryEpsilon) continue;
      if (interval(spans, count, previous, next, start, size, scale, out) && !all) return;
      previous = next;
    }
  }

  bool interval(const Span* spans, int count, double from, double to, double start, double size,
                double scale, HitStack& out) const {
    double c[5] = {0, 0, 0, 0, -threshold_};
    const double middle = 0.5 * (from + to);
    for (int i = 0; i < count; ++i) {
      const Span& s = spans[i];
      if (s.from > middle || s.to < middle) continue;
      const Part& p = *s.part;
      c[0] += p.c0 * s.a * s.a;
      c[1] += 2 * p.c0 * s.a * s.b;
      c[2] += p.c0 * (2 * s.a * s.c + s.b * s.b) + p.c1 * s.a;
      c[3] += 2 * p.c0 * s.b * s.c + p.c1 * s.b;
      c[4] += p.c0 * s.c * s.c + p.c1 * s.c + p.c2;
    }
    if (has_one_sign(c, from, to)) return false;
    double roots[4];
    const int found = solve_polynomial(4, c, sturm_, kRootElimination, roots);
    bool any = false;
    for (int i = 0; i < found; ++i) {
      if (roots[i] < from || roots[i] > to) continue;
      const double t = (roots[i] * size + start) * scale;
      if (t > kLeastDepth && t < kGreatestDepth) {
        out.push(t);
        any = true;
      }
    }
    return any;
  }

  // The Bernstein coefficients over [from, to] enclose the quartic.
  static bool has_one_sign(const double* c, double from, double to) {
    const double w = to - from, l = from;
    const double q0 = (((c[0] * l + c[1]) * l + c[2]) * l + c[3]) * l + c[4];
    const double q1 = (((4 * c[0] * l + 3 * c[1]) * l + 2 * c[2]) * l + c[3]) * w;
    const double q2 = ((6 * c[0] * l + 3 * c[1]) * l + c[2]) * w * w;
    const double q3 = (4 * c[0] * l + c[1]) * w * w * w;
    const double q4 = c[0] * w * w * w * w;
    const double b[5] = {q0, q0 + q1 / 4, q0 + q1 / 2 + q2 / 6, q0 + 0.75 * q1 + q2 / 2 + q3 / 4,
                         q0 + q1 + q2 + q3 + q4};
    bool positive = true, negative = true;
    for (const double v : b) {
      positive &= v >= 0;
      negative &= v <= 0;
    }
    return positive || negative;
  }

  template <typename Visit>
  void for_parts_at(const Vec3& p, Visit&& visit) const {
    int stack[64], depth = 0;
    if (nodes_.empty()) return;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[static_cast<size_t>(stack[--depth])];
      const Vec3 slack(1e-9 * (1 + length(node.box.max - node.box.min)));
      const Vec3 below = node.box.min - slack, above = node.box.max + slack;
      if (p.x < below.x || p.y < below.y || p.z < below.z || p.x > above.x || p.y > above.y ||
          p.z > above.z)
        continue;
      if (node.left >= 0) {
        stack[depth++] = node.right;
        stack[depth++] = node.left;
        continue;
      }
      for (int i = node.first; i < node.first + node.count; ++i) visit(part_at(i));
    }
  }

  double field(const Vec3& p) const {
    double sum = 0;
    for_parts_at(p, [&](const Part& part) { sum += part.field(p); });
    return sum;
  }

  double threshold_;
  bool sturm_;
  bool has_textures_ = false, all_textured_ = false;
  std::vector<Part> parts_;
  std::vector<int> order_;  // parts by the hierarchy's leaves
  std::vector<Node> nodes_;
  std::vector<TexturePtr> textures_;
  Bounds box_;
};

}  // namespace

PlacedShape compile(const BlobNode& node, const ShapeContext&) {
  return {std::make_shared<Blob>(node), false, {}};
}

}  // namespace durer
