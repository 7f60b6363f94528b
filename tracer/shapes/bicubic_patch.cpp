// bicubic_patch { type … 16 points }: subdivided into triangles        (spec/geometry.md 13.6)
#include <algorithm>
#include <array>
#include <cmath>

#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kLeastDepth = 1e-5;

using Points = std::array<std::array<Vec3, 4>, 4>;  // [row: u][column: v]

struct Ball {
  Vec3 center{0};
  double radius2 = 0;

  explicit Ball(const Points& p) {
    for (const auto& row : p)
      for (const Vec3& q : row) center += q;
    center = center / 16.0;
    for (const auto& row : p)
      for (const Vec3& q : row) radius2 = std::max(radius2, dot(q - center, q - center));
  }
  bool met_by(const Vec3& origin, const Vec3& unit_direction) const {
    const Vec3 offset = center - origin;
    const double distance2 = dot(offset, offset), along = dot(offset, unit_direction);
    if (distance2 < radius2) return true;
    return along != 0 && distance2 - along * along <= radius2 + kGeometryEpsilon;
  }
};

void split_line(const Vec3* p, Vec3* low, Vec3* high) {
  const Vec3 middle = 0.5 * (p[1] + p[2]);
  const Vec3 p0 = p[0], p3 = p[3];
  low[0] = p0;
  low[1] = 0.5 * (p0 + p[1]);
  low[2] = 0.5 * (low[1] + middle);
  high[3] = p3;
  high[2] = 0.5 * (p[2] + p3);
  high[1] = 0.5 * (middle + high[2]);
  low[3] = high[0] = 0.5 * (low[2] + high[1]);
}
void split_v(const Points& p, Points& low, Points& high) {
  for (size_t i = 0; i < 4; ++i) split_line(p[i].data(), low[i].data(), high[i].data());
}
void split_u(const Points& p, Points& low, Points& high) {
  for (size_t j = 0; j < 4; ++j) {
    Vec3 line[4], a[4], b[4];
    for (size_t i = 0; i < 4; ++i) line[i] = p[i][j];
    split_line(line, a, b);
    for (size_t i = 0; i < 4; ++i) {
      low[i][j] = a[i];
      high[i][j] = b[i];
    }
  }
}

// All points within `flatness` of the plane through the first corners of both rows and the other
// corner of the first, or the opposite one where that row has shrunk to a point.
bool is_flat(const Points& p, double flatness) {
  if (flatness <= 0) return false;
  const Vec3& origin = p[0][0];
  const Vec3& across = p[0][3] == origin ? p[3][3] : p[0][3];
  const Vec3 normal = unit_or_zero(cross(across - origin, p[3][0] - origin));
  if (normal == Vec3(0)) return false;
  for (const auto& row : p)
    for (const Vec3& q : row)
      if (std::abs(dot(q - origin, normal)) >= flatness) return false;
  return true;
}

struct Piece {  // a node of the tree of pieces; leaves have no children
  Ball ball;
  Vec3 corner[4];  // (u0,v0) (u0,v1) (u1,v1) (u1,v0)
  float u0, u1, v0, v1;
  int first_child = -1, children = 0;
};

class BicubicPatch final : public Shape {
 public:
  explicit BicubicPatch(const BicubicPatchNode& node)
      : node_(node), flatness_(node.flatness), u_steps_(node.u_steps), v_steps_(node.v_steps) {
    for (size_t i = 0; i < 16; ++i) {
      points_[i / 4][i % 4] = node.points[i];
      box_.extend(node.points[i]);
    }
    uv_ = node.uv.value_or(std::array<Vec2, 4>{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)});
    pieces_.push_back(piece(points_, 0, 1, 0, 1));
    build(0, points_, 0, 0, 1, 0, 1);
  }

  Bounds bounds() const override { return box_; }
  // The points move, so that flatness and the least depth are lengths of the scene.
  std::shared_ptr<const Shape> transformed(const Transform& transform) const override {
    BicubicPatchNode moved = node_;
    for (Vec3& point : moved.points) point = transform.point(point);
    return std::make_shared<BicubicPatch>(moved);
  }
  bool is_patch() const override { return true; }
  bool ignores_clips() const override { return true; }
  bool inside(const Vec3&) const override { return false; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const double scale = 1 / length(ray.direction);
    walk(0, ray.origin, ray.direction * scale, scale, out);
  }

  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override {
    Vec2 corners[3];
    corner_parameters(hit.part, corners);
    double b, c;
    Facet(pieces_[hit.part / 2], hit.part % 2).weights(p, b, c);
    return unit_or_zero((1 - b - c) * patch_normal(corners[0]) + b * patch_normal(corners[1]) +
                             c * patch_normal(corners[2]));
  }

  Vec2 uv(const Vec3& p, const Vec3&, const ShapeHit& hit) const override {
    Vec2 corners[3];
    corner_parameters(hit.part, corners);
    double b, c;
    Facet(pieces_[hit.part / 2], hit.part % 2).weights(p, b, c);
    const Vec2 at = (1 - b - c) * corners[0] + b * corners[1] + c * corners[2];
    const Vec2 e = uv_[0] + at.y * (uv_[1] - uv_[0]), f = uv_[3] + at.y * (uv_[2] - uv_[3]);
    return e + at.x * (f - e);
  }

 private:
  static Piece piece(const Points& p, double u0, double u1, double v0, double v1) {
    return {Ball(p), {p[0][0], p[0][3], p[3][3], p[3][0]},
            static_cast<float>(u0), static_cast<float>(u1), static_cast<float>(v0),
            static_cast<float>(v1)};
  }

  void build(int index, const Points& p, int depth, double u0, double u1, double v0, double v1) {
    const bool u_left = depth < u_steps_, v_left = depth < v_steps_;
    if ((!u_left && !v_left) || is_flat(p, flatness_)) return;
    const double u = 0.5 * (u0 + u1), v = 0.5 * (v0 + v1);
    struct Part {
      Points points;
      double u0, u1, v0, v1;
    };
    std::vector<Part> parts;
    if (u_left) {
      Points low, high;
      split_u(p, low, high);
      parts.push_back({low, u0, u, v0, v1});
      parts.push_back({high, u, u1, v0, v1});
    } else {
      parts.push_back({p, u0, u1, v0, v1});
    }
    if (v_left) {
      std::vector<Part> halves;
      for (const Part& part : parts) {
        Points low, high;
        split_v(part.points, low, high);
        halves.push_back({low, part.u0, part.u1, v0, v});
        halves.push_back({high, part.u0, part.u1, v, v1});
      }
      parts = std::move(halves);
    }
    const int first = static_cast<int>(pieces_.size());
    pieces_[static_cast<size_t>(index)].first_child = first;
    pieces_[static_cast<size_t>(index)].children = static_cast<int>(parts.size());
    for (const Part& part : parts)
      pieces_.push_back(piece(part.points, part.u0, part.u1, part.v0, part.v1));
    for (size_t i = 0; i < parts.size(); ++i) {
      const Part& part = parts[i];
      build(first + static_cast<int>(i), part.points, depth + 1, part.u0, part.u1, part.v0, part.v1);
    }
  }

  void walk(int index, const Vec3& o, const Vec3& d, double scale, HitStack& out) const {
    const Piece& piece = pieces_[static_cast<size_t>(index)];
    if (!piece.ball.met_by(o, d)) return;
    if (piece.children == 0) {
      triangle(piece, index, 0, o, d, scale, out);
      triangle(piece, index, 1, o, d, scale, out);
      return;
    }
    for (int i = 0; i < piece.children; ++i) walk(piece.first_child + i, o, d, scale, out);
  }

  // Triangle 0: corners 0 1 2; triangle 1: corners 0 2 3.
  struct Facet {
    Facet(const Piece& piece, int which)
        : a(piece.corner[0]),
          e1(piece.corner[which + 1] - a),
          e2(piece.corner[which + 2] - a),
          n(cross(e1, e2)),
          n2(dot(n, n)) {}
    // Of the second and the third corner at a point of its plane.
    void weights(const Vec3& p, double& b, double& c) const {
      const Vec3 q = p - a;
      b = dot(cross(q, e2), n) / n2;
      c = dot(cross(e1, q), n) / n2;
    }

    Vec3 a, e1, e2, n;
    double n2;
  };

  static void triangle(const Piece& piece, int index, int which, const Vec3& o, const Vec3& d,
                       double scale, HitStack& out) {
    const Facet facet(piece, which);
    if (facet.n2 <= kGeometryEpsilon * dot(facet.e1, facet.e1) * dot(facet.e2, facet.e2)) return;
    const double along = dot(facet.n, d);
    if (along == 0) return;
    const double t = dot(facet.n, facet.a - o) / along;
    if (!(t * scale >= kLeastDepth)) return;
    double b, c;
    facet.weights(o + t * d, b, c);
    if (b < 0 || c < 0 || b + c > 1) return;
    out.push(t * scale, static_cast<uint32_t>(2 * index + which));
  }

  // (u, v) at the corners of a triangle.
  void corner_parameters(uint32_t part, Vec2* corners) const {
    const Piece& p = pieces_[part / 2];
    const double u0 = static_cast<double>(p.u0), u1 = static_cast<double>(p.u1);
    const double v0 = static_cast<double>(p.v0), v1 = static_cast<double>(p.v1);
    corners[0] = {u0, v0};
    corners[1] = part % 2 ? Vec2(u1, v1) : Vec2(u0, v1);
    corners[2] = part % 2 ? Vec2(u1, v0) : Vec2(u1, v1);
  }

  Vec3 patch_normal(const Vec2& at) const {
    double bu[4], bv[4], du[4], dv[4];
    bernstein(at.x, bu, du);
    bernstein(at.y, bv, dv);
    Vec3 along_u(0), along_v(0);
    for (size_t i = 0; i < 4; ++i) {
      for (size_t j = 0; j < 4; ++j) {
        along_u += du[i] * bv[j] * points_[i][j];
        along_v += bu[i] * dv[j] * points_[i][j];
      }
    }
    const Vec3 n = cross(along_u, along_v);
    const double squared = dot(n, n);
    // Where an edge has shrunk to a point, what rounding leaves decides, as in POV-Ray.
    return squared > 0 ? n / std::sqrt(squared) : Vec3(1, 0, 0);
  }
  static void bernstein(double t, double* b, double* derivative) {
    const double s = 1 - t;
    b[0] = s * s * s, b[1] = 3 * t * s * s, b[2] = 3 * t * t * s, b[3] = t * t * t;
    derivative[0] = -3 * s * s, derivative[1] = 3 * s * (s - 2 * t);
    derivative[2] = 3 * t * (2 * s - t), derivative[3] = 3 * t * t;
  }

  Points points_;
  Bounds box_;
  std::array<Vec2, 4> uv_;
  std::vector<Piece> pieces_;
  BicubicPatchNode node_;
  double flatness_;
  int u_steps_, v_steps_;
};

}  // namespace

PlacedShape compile(const BicubicPatchNode& node, const ShapeContext&) {
  return {std::make_shared<BicubicPatch>(node), false, {}};
}

}  // namespace durer
