// pavement: tiles made of several squares, triangles or hexagons, in the xz plane.
//
//   number_of_sides   3, 4 or 6                 3
//   number_of_tiles   1..6 (hexagons 1..5)      1
//   pattern           which tile of that size   1
//   exterior          outer corners, 0..2       0   (bevelled or rounded)
//   interior          inner corners, 0..2       0
//   form              corners that meet, 0..3   0   (squares), 0..2 otherwise
//
//   pigment { pavement number_of_sides 6 number_of_tiles 3 pattern 2 interior 1 }
//
// Source: spec/textures.md 9.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/patterns/pattern_factories.h"
#include "tracer/patterns/pavement_tables.h"

namespace durer {
namespace {

constexpr double kRoot3 = std::numbers::sqrt3, kHalfRoot3 = kRoot3 / 2;

int64_t floor_mod(int64_t a, int64_t b) { return ((a % b) + b) % b; }
int64_t to_cell(double v) {
  return static_cast<int64_t>(std::clamp(std::floor(v), -1e17, 1e17));
}

// Offset of cell (q, r) in the table.
int64_t cell_of(const PavementTable& table, int64_t q, int64_t r) {
  const int64_t m = (r - floor_mod(r, table.rows)) / table.rows;
  return (r - m * table.rows) * table.columns + floor_mod(q - m * table.shift, table.columns);
}

class SquarePavement : public BasePattern {
 public:
  SquarePavement(const PavementTable& table, const PavementParameters& parameters)
      : table_(table), exterior_(parameters.exterior & 255), interior_(parameters.interior & 255),
        form_((parameters.form & 255) % 4) {
    exterior_ %= 3;
    interior_ %= 3;
  }
  double base_value(const Vec3& p, const PatternContext&) const override;
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  PavementTable table_;
  int exterior_, interior_, form_;
};

double SquarePavement::base_value(const Vec3& p, const PatternContext&) const {
  const double u = p.x - std::floor(p.x), w = p.z - std::floor(p.z);
  const int code = kPavementCells[table_.first_cell + cell_of(table_, to_cell(p.x), to_cell(p.z))];
  const bool top = code & 1, right = code & 2, bottom = code & 4, left = code & 8;

  // Corners: place, dot, the two edges there, and those of the corner across.
  struct Corner {
    double u, w;
    bool dot, edges, facing;
  };
  const Corner corners[4] = {{0, 1, (code & 16) != 0, top && left, right && bottom},
                             {1, 1, (code & 32) != 0, top && right, left && bottom},
                             {1, 0, (code & 64) != 0, right && bottom, top && left},
                             {0, 0, (code & 128) != 0, left && bottom, top && right}};

  if (form_ < 3) {
    for (const Corner& c : corners) {
      if (!c.dot || !c.facing) continue;
      const double a = 2 * std::abs(u - c.u), b = 2 * std::abs(w - c.w);
      if (form_ == 0) return std::max({a - 1, b - 1, std::min(1 - a, 1 - b)});
      if (form_ == 1) return std::min(1.0, std::abs(a + b - 1));
      return std::min(1.0, std::abs(std::sqrt(a * a + b * b) - 1));
    }
  }
  double v = 0;
  if (top) v = std::max(v, 1 - 2 * (1 - w));
  if (right) v = std::max(v, 1 - 2 * (1 - u));
  if (bottom) v = std::max(v, 1 - 2 * w);
  if (left) v = std::max(v, 1 - 2 * u);
  for (const Corner& c : corners) {
    const double a = 2 * std::abs(u - c.u), b = 2 * std::abs(w - c.w);
    if (c.dot) {
      const double t = interior_ == 0   ? std::min(1 - a, 1 - b)
                       : interior_ == 1 ? 1 - (a + b)
                                        : 1 - std::sqrt(a * a + b * b);
      v = std::max(v, t);
    }
    if (!c.edges) continue;
    if (exterior_ == 1) v = std::max(v, std::min(1.0, 2 - (a + b)));
    if (exterior_ == 2 && a <= 1 && b <= 1) {
      const double s = 2 * u - 1, t = 2 * w - 1;
      v = std::max(v, std::min(1.0, std::sqrt(s * s + t * t)));
    }
  }
  return v;
}

class TrianglePavement : public BasePattern {
 public:
  TrianglePavement(const PavementTable& table, const PavementParameters& parameters)
      : table_(table), exterior_((parameters.exterior & 255) % 3),
        interior_((parameters.interior & 255) % 3), form_((parameters.form & 255) % 3) {
    if (table.sides == 6) exterior_ = 0;  // hexagons ignore it
  }
  double base_value(const Vec3& p, const PatternContext&) const override;
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  PavementTable table_;
  int exterior_, interior_, form_;
};

double TrianglePavement::base_value(const Vec3& p, const PatternContext&) const {
  // The unit triangle that holds the point, and the point in it.
  const double row = std::floor(p.z / kHalfRoot3);
  double z = p.z - row * kHalfRoot3;
  const double shifted = p.x - row / 2;
  const double column = std::floor(shifted - z / kRoot3);
  double x = shifted - column;
  int64_t entry = 2 * cell_of(table_, to_cell(column), to_cell(row));
  if (!(z <= kRoot3 * (1 - x))) {
    x = 1.5 - x;
    z = kHalfRoot3 - z;
    ++entry;
  }
  const int code = kPavementCells[table_.first_cell + entry];
  const bool left = code & 1, right = code & 2, bottom = code & 4;
  const bool dot_a = code & 8, dot_l = code & 16, dot_r = code & 32;

  // Medians and corner zones.
  const double f1 = kRoot3 * z + x, f2 = kRoot3 * z - x + 1, f3 = 2 * x;
  const bool zone_a = f1 > 1 && f2 > 1, zone_l = f1 < 1 && f3 < 1, zone_r = f3 > 1 && f2 < 1;

  if (form_ > 0) {
    const int zone = zone_a ? 1 : zone_l ? 2 : zone_r ? 3 : 0;
    const int pivot = zone == 0 ? 0 : (code >> (4 + 2 * zone)) & 3;
    if (pivot != 0) {
      if (form_ == 1) {
        const int third = 6 - zone - pivot;  // A, L, R are 1, 2, 3
        const double median = third == 1 ? f3 : third == 2 ? f2 : f1;
        return std::min(1.0, 2 * std::abs(median - 1));
      }
      const double px = pivot == 1 ? 0.5 : pivot == 2 ? 0 : 1, pz = pivot == 1 ? kHalfRoot3 : 0;
      const double distance = std::sqrt((x - px) * (x - px) + (z - pz) * (z - pz));
      return std::clamp(2 * kRoot3 * (std::abs(distance) - kRoot3 / 3), 0.0, 1.0);
    }
  }

  const double dl = kRoot3 * std::abs(kRoot3 * x - z);
  const double dr = kRoot3 * std::abs(kRoot3 * (1 - x) - z);
  const double db = 2 * kRoot3 * z;
  double v = 0;
  if (left) v = std::max(v, 1 - dl);
  if (right) v = std::max(v, 1 - dr);
  if (bottom) v = std::max(v, 1 - db);

  if (interior_ == 0) {
    if (dot_a) v = std::max(v, 1 - 2 * kRoot3 * (kHalfRoot3 - z));
    if (dot_l) v = std::max(v, 1 - kRoot3 * (kRoot3 * x + z));
    if (dot_r) v = std::max(v, 1 - kRoot3 * (kRoot3 * (1 - x) + z));
  } else if (interior_ == 1) {
    if (dot_a && zone_a) v = std::max(v, std::min(1.5 * f1 - 2, 1.5 * f2 - 2));
    if (dot_l && zone_l) v = std::max(v, std::min(1 - 1.5 * f1, 1 - 3 * x));
    if (dot_r && zone_r) v = std::max(v, std::min(1 - 1.5 * f2, 3 * x - 2));
  } else {
    const auto away = [&](double cx, double cz) {
      return 1 - 3 * std::sqrt((x - cx) * (x - cx) + (z - cz) * (z - cz));
    };
    if (dot_a) v = std::max(v, away(0.5, kHalfRoot3));
    if (dot_l) v = std::max(v, away(0, 0));
    if (dot_r) v = std::max(v, away(1, 0));
  }

  const double alpha = x - 0.5, beta = z - kHalfRoot3 / 3;
  if (exterior_ == 2) {
    const bool rounded = (left && right && f1 >= 1 && f2 >= 1) ||
                         (left && bottom && f1 <= 1 && f3 <= 1) ||
                         (right && bottom && f3 >= 1 && f2 <= 1);
    if (rounded) v = std::min(1.0, 2 * kRoot3 * std::sqrt(alpha * alpha + beta * beta));
  } else if (exterior_ == 1) {
    if (left && right && dl <= 1 && dr <= 1) v = std::min(1.0, 2 * kRoot3 * std::abs(beta));
    if (right && bottom && dr <= 1 && db <= 1)
      v = std::min(1.0, kRoot3 * std::abs(kRoot3 * alpha - beta));
    if (left && bottom && dl <= 1 && db <= 1)
      v = std::min(1.0, kRoot3 * std::abs(kRoot3 * alpha + beta));
  }
  return v;
}

}  // namespace

std::unique_ptr<const BasePattern> make_pavement(const PatternNode& node, const PatternSettings&) {
  // The parser has checked the numbers.
  const PavementParameters& wanted = node.pavement;
  const PavementTable* table = kPavements;
  for (const PavementTable& candidate : kPavements) {
    if (candidate.sides == wanted.sides && candidate.tiles == wanted.tiles &&
        candidate.pattern == wanted.pattern)
      table = &candidate;
  }
  if (table->sides == 4) return std::make_unique<SquarePavement>(*table, wanted);
  return std::make_unique<TrianglePavement>(*table, wanted);
}

}  // namespace durer
