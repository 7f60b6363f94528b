// tiling 1..24: edge-to-edge tilings of the xz plane by polygons of unit side.
//
//   tiling N   N: 1..27 (25..27 are in penrose.cpp)
//
//   pigment { tiling 7 color_map { [0 rgb 1] [0.5 rgb 0] [0.5 rgb <1,.5,0>] [1 rgb 0] } }
//
// With n classes of tiles the value runs from c/n inside a tile of class c to (c+1)/n on its edges.
// Source: spec/textures.md 8.
#include <algorithm>
#include <cmath>
#include <vector>

#include "tracer/patterns/pattern_factories.h"
#include "tracer/patterns/penrose.h"
#include "tracer/patterns/tiling_tables.h"

namespace durer {
namespace {

class Tiling : public BasePattern {
 public:
  explicit Tiling(int number);
  double base_value(const Vec3& p, const PatternContext&) const override;
  ValueRange base_range(const Bounds&) const override { return {0, 1.0000001}; }

 private:
  struct Edge {
    Vec2 inward;  // unit normal
    double offset;
    double scale;
  };
  struct Tile {
    int tile_class;
    bool tilted;  // a square that is not parallel to the axes
    std::vector<Edge> edges;
  };
  void add_copy(const TilingPolygon& polygon, const Vec2& shift);
  Vec2 tie_shift(const Vec3& p) const;
  bool is_on_mirror(const Vec3& p) const;
  double value_on_mirror(const Vec3& p, int tile_class, double numerator) const;
  double adjusted(double numerator, const Tile& tile) const;

  int number_;
  int classes_;
  Vec2 a_, b_;              // lattice
  double inverse_[2][2];    // to lattice coordinates
  std::vector<Tile> tiles_;  // all that reach into the period [0,1) a + [0,1) b
};

Tiling::Tiling(int number) : number_(number) {
  const TilingTable& table = kTilings[number - 1];
  classes_ = table.classes;
  a_ = table.lattice[0];
  b_ = table.lattice[1];
  const double determinant = a_.x * b_.y - a_.y * b_.x;
  inverse_[0][0] = b_.y / determinant;
  inverse_[0][1] = -b_.x / determinant;
  inverse_[1][0] = -a_.y / determinant;
  inverse_[1][1] = a_.x / determinant;

  // On a common edge the tile that comes first wins: in 13 and 14 the upper and lower trapezia.
  std::vector<TilingPolygon> polygons(kTilingPolygons + table.first_polygon,
                                      kTilingPolygons + table.first_polygon +
                                          table.polygon_count);
  if (number == 13 || number == 14) {
    std::stable_sort(polygons.begin(), polygons.end(), [&](const auto& l, const auto& r) {
      return number == 13 ? l.tile_class < r.tile_class : l.tile_class > r.tile_class;
    });
  }

  // Copies of each polygon whose extent in lattice coordinates meets the unit square.
  for (const TilingPolygon& polygon : polygons) {
    Vec2 low(1e9), high(-1e9);
    for (int k = 0; k < polygon.vertex_count; ++k) {
      const Vec2 v = kTilingVertices[polygon.first_vertex + k];
      const Vec2 l(inverse_[0][0] * v.x + inverse_[0][1] * v.y,
                   inverse_[1][0] * v.x + inverse_[1][1] * v.y);
      low = glm::min(low, l);
      high = glm::max(high, l);
    }
    for (int u = static_cast<int>(std::floor(-high.x)); u + low.x < 1.000001; ++u) {
      for (int v = static_cast<int>(std::floor(-high.y)); v + low.y < 1.000001; ++v) {
        if (u + high.x < -1e-6 || v + high.y < -1e-6) continue;
        add_copy(polygon, static_cast<double>(u) * a_ + static_cast<double>(v) * b_);
      }
    }
  }
}

void Tiling::add_copy(const TilingPolygon& polygon, const Vec2& shift) {
  Tile tile{polygon.tile_class, false, {}};
  for (int k = 0; k < polygon.vertex_count; ++k) {
    const Vec2 from = kTilingVertices[polygon.first_vertex + k] + shift;
    const Vec2 to =
        kTilingVertices[polygon.first_vertex + (k + 1) % polygon.vertex_count] + shift;
    const Vec2 along = glm::normalize(to - from);
    Edge edge{{-along.y, along.x}, 0, polygon.scale};
    edge.offset = -glm::dot(edge.inward, from);
    // Tiling 22: three edges of the dodecagon fall off more slowly.
    if (number_ == 22 && tile.tile_class == 2) {
      // Outward normals +x, -x and -z.
      if (std::abs(edge.inward.x) > 0.999 || edge.inward.y > 0.999) edge.scale = 1.0 / 3;
    }
    tile.tilted = tile.tilted || std::min(std::abs(along.x), std::abs(along.y)) > 1e-6;
    tile.edges.push_back(edge);
  }
  tiles_.push_back(std::move(tile));
}

// Where a point on a common edge is looked for: on the side of the tile to which POV-Ray gives the edge
// (faces of boxes and planes such as z = 0 may lie on edges all over; measured on povray 3.7). Tilings
// that it folds at a mirror give edges to the tile farther from it, or nearer.
Vec2 Tiling::tie_shift(const Vec3& p) const {
  constexpr double kAlongX = 1e-11, kAlongZ = 1e-9;
  const auto away_from = [](double v, double mirror) { return v < mirror ? -1.0 : 1.0; };
  const auto towards_sixth = [](double v) { return v - 6 * std::round(v / 6) > 0 ? -1.0 : 1.0; };
  switch (number_) {
    case 8: return {kAlongX, p.z > 0 ? -kAlongZ : kAlongZ};
    case 12: return {towards_sixth(p.x) * kAlongX, towards_sixth(p.z) * kAlongZ};
    case 13:
    case 14: return {0, 0};  // by the order of the tiles
    case 16:
    case 17: return {away_from(p.x, -1) * kAlongX, away_from(p.z, 0) * kAlongZ};
    case 19:
    case 20: {
      const double x = p.x - 7 * std::floor(p.x / 7);
      const bool below = number_ == 19 ? (x > 2.5 && x < 3) || (x > 4 && x < 5) : x > 4;
      return {kAlongX, below ? -kAlongZ : kAlongZ};
    }
    case 23:
    case 24: return {away_from(p.x, 0) * kAlongX, away_from(p.z, 0) * kAlongZ};
    default: return {kAlongX, kAlongZ};
  }
}

// The very lines at which POV-Ray folds some tilings have values of their own (measured on povray 3.7).
bool Tiling::is_on_mirror(const Vec3& p) const {
  switch (number_) {
    case 3: return p.x == std::floor(p.x);
    case 12: return std::fmod(p.x, 6) == 0 || std::fmod(p.z, 6) == 0;
    case 13:
    case 14: return p.x == 0 || p.z == 0;
    default: return false;
  }
}

double Tiling::value_on_mirror(const Vec3& p, int tile_class, double numerator) const {
  if (number_ == 3) return (numerator + 1 - 2 * tile_class) / classes_;  // the other class
  if (number_ != 12) return 0;
  const double z = std::abs(p.z - 6 * std::round(p.z / 6));
  return (z >= 1 && z <= 2 ? 0.99997 : 0.99994) / classes_;
}

double Tiling::base_value(const Vec3& p, const PatternContext&) const {
  // The point in the period at the origin.
  const double s = inverse_[0][0] * p.x + inverse_[0][1] * p.z;
  const double t = inverse_[1][0] * p.x + inverse_[1][1] * p.z;
  const Vec2 q(p.x - std::floor(s) * a_.x - std::floor(t) * b_.x,
               p.z - std::floor(s) * a_.y - std::floor(t) * b_.y);

  // The tile that contains it: the one whose nearest edge line is furthest inside.
  const Vec2 sought = q + tie_shift(p);
  const Tile* found = nullptr;
  double best = -1e300;
  for (const Tile& tile : tiles_) {
    double least = 1e300;
    for (const Edge& edge : tile.edges) {
      least = std::min(least, glm::dot(edge.inward, sought) + edge.offset);
      if (least <= best + 1e-12) break;
    }
    if (least > best + 1e-12) {
      best = least;
      found = &tile;
      if (best > 1e-9) break;
    }
  }
  if (!found) return 0;  // NaN coordinates
  double ratio = 1e300;
  for (const Edge& edge : found->edges)
    ratio = std::min(ratio, (glm::dot(edge.inward, q) + edge.offset) / edge.scale);
  const double numerator = found->tile_class + std::max(0.0, 1 - std::max(0.0, ratio));
  if (is_on_mirror(p)) [[unlikely]] return value_on_mirror(p, found->tile_class, numerator);
  return adjusted(numerator, *found);
}

// Offsets that put flat interiors on the upper side of a double map entry.
double Tiling::adjusted(double numerator, const Tile& tile) const {
  const int c = tile.tile_class;
  const double n = classes_;
  switch (number_) {
    case 7: return c == 1 ? std::max(numerator / n, 0.500000000001) : numerator / n;
    case 8: return (c == 2 ? numerator + 1e-7 : numerator) / n;
    case 9:
    case 16: return c == 2 ? std::max(numerator / n, 2.0000001 / 3) : numerator / n;
    case 14: return (c == 4 ? numerator + 1e-6 : numerator) / n;
    case 15: return c == 1 ? numerator / n + 1e-8 : numerator / n;
    case 17:
      if (c == 5) return std::max(numerator / n, 5.000001 / 6);
      return (c <= 2 && tile.tilted ? numerator + 1e-6 : numerator) / n;
    case 19:
    case 20: return c == 2 ? std::max(numerator / n, 2.000001 / 3) : numerator / n;
    case 21:
      if (c == 4) return std::clamp(numerator / n, 4.000001 / 6, 5.0 / 6);
      if (c == 5) return std::clamp(numerator / n, 5.000001 / 6, 1.0);
      return numerator / n;
    case 22: return (c == 2 ? numerator + 1e-7 : numerator) / n;
    case 23: return (c == 2 ? numerator + 1e-6 : numerator) / n;
    case 24: return (c == 4 ? numerator + 1e-6 : numerator) / n;
    default: return numerator / n;
  }
}

class PenroseTiling : public BasePattern {
 public:
  explicit PenroseTiling(int number) : number_(number) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    return penrose_tiling(number_, p.x, p.z);
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  int number_;
};

}  // namespace

std::unique_ptr<const BasePattern> make_tiling(const PatternNode& node, const PatternSettings&) {
  if (node.tiling_type >= 25) return std::make_unique<PenroseTiling>(node.tiling_type);
  return std::make_unique<Tiling>(std::max(node.tiling_type, 1));
}

}  // namespace durer
