// height_field { image [water_level f] [smooth] }                    (spec/geometry.md 12.14)
//
// An open sheet over the unit square, two triangles per cell of the image. In the grid's own space
// the vertices have whole coordinates; the object's transforms are taken into the shape, as smooth
// normals are mixed after they have been moved.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "tracer/math/min_max.h"
#include "tracer/shapes/box_crossing.h"
#include "tracer/shapes/height_grid.h"
#include "tracer/shapes/shape.h"

namespace durer {
namespace {

constexpr double kBoxMargin = 0.001;     // of the heights
constexpr double kEdgeOverlap = 0.0001;  // of a cell: triangles reach that far beyond their edges
constexpr double kLeastDepth = 1e-6;
// Rays are looked at this much (in heights) above and below where a block is crossed.
constexpr double kHeightSlack = 0.01;

// A walk over the grid along a ray: blocks first, the cells of those that it may hit after.
template <typename Sink>
class Walk {
 public:
  Walk(const HeightGrid& grid, const Ray& ray, double from, double to, Sink& sink)
      : grid_(grid),
        ray_(ray),
        from_(from),
        to_(to),
        inverse_x_(1 / ray.direction.x),
        inverse_z_(1 / ray.direction.z),
        sink_(sink) {}

  void run() {
    const int top = grid_.level_count() - 1;
    walk(top, 0, 0, 1, 1, from_, to_);
  }

 private:
  // The blocks of one level from (low_x, low_z) up to, without, (high_x, high_z), between two
  // depths. False: the search is over.
  bool walk(int level, int low_x, int low_z, int high_x, int high_z, double enter, double leave) {
    const int shift = level * HeightGrid::kLevelShift;
    const double size = static_cast<double>(int64_t{1} << shift);
    const double per_size = 1 / size;  // of a power of two: exact
    const auto start = [&](double o, double d, int low, int high) {
      const double cell = (o + enter * d) * per_size;
      return static_cast<int>(larger_of(smaller_of(cell, high - 1), low));
    };
    int x = start(ray_.origin.x, ray_.direction.x, low_x, high_x);
    int z = start(ray_.origin.z, ray_.direction.z, low_z, high_z);
    const int step_x = ray_.direction.x > 0 ? 1 : -1, step_z = ray_.direction.z > 0 ? 1 : -1;
    const auto border_x = [&](int i) {
      return ray_.direction.x == 0 ? HUGE_VAL
                                   : ((i + (step_x > 0)) * size - ray_.origin.x) * inverse_x_;
    };
    const auto border_z = [&](int i) {
      return ray_.direction.z == 0 ? HUGE_VAL
                                   : ((i + (step_z > 0)) * size - ray_.origin.z) * inverse_z_;
    };
    double next_x = border_x(x), next_z = border_z(z);
    double t = enter;
    for (;;) {
      const double end = std::min(std::min(next_x, next_z), leave);
      const double y1 = ray_.origin.y + t * ray_.direction.y;
      const double y2 = ray_.origin.y + end * ray_.direction.y;
      const HeightGrid::Range range = grid_.range(level, x, z);
      if (std::max(y1, y2) + kHeightSlack >= range.low &&
          std::min(y1, y2) - kHeightSlack <= range.high && !visit(level, x, z, t, end)) {
        return false;
      }
      if (end >= leave) return true;
      t = std::max(t, end);
      if (next_x <= next_z) {
        x += step_x;
        if (x < low_x || x >= high_x) return true;
        next_x = border_x(x);
      } else {
        z += step_z;
        if (z < low_z || z >= high_z) return true;
        next_z = border_z(z);
      }
    }
  }

  bool visit(int level, int x, int z, double enter, double leave) {
    if (level == 0) return test_cell(x, z);
    const int shift = (level - 1) * HeightGrid::kLevelShift;
    const int high_x =
        std::min((x + 1) << HeightGrid::kLevelShift, ((grid_.columns() - 2) >> shift) + 1);
    const int high_z =
        std::min((z + 1) << HeightGrid::kLevelShift, ((grid_.rows() - 2) >> shift) + 1);
    return walk(level - 1, x << HeightGrid::kLevelShift, z << HeightGrid::kLevelShift, high_x,
                high_z, enter, leave);
  }

  bool test_cell(int x, int z) {
    const double h1 = grid_.height(x, z), h2 = grid_.height(x + 1, z);
    const double h3 = grid_.height(x, z + 1), h4 = grid_.height(x + 1, z + 1);
    bool found = false;
    double s, t;
    double depth = cross({h1 - h2, 1, h1 - h3}, Vec3(x, h1, z));
    if (depth >= from_ && depth <= to_) {
      local(depth, x, z, s, t);
      if (s >= -kEdgeOverlap && t >= -kEdgeOverlap && s + t <= 1 + kEdgeOverlap) {
        sink_.push(depth, part(x, z, 0));
        found = true;
      }
    }
    depth = cross({h3 - h4, 1, h2 - h4}, Vec3(x + 1, h4, z + 1));
    if (depth >= from_ && depth <= to_) {
      local(depth, x, z, s, t);
      if (s <= 1 + kEdgeOverlap && t <= 1 + kEdgeOverlap && s + t >= 1 - kEdgeOverlap) {
        sink_.push(depth, part(x, z, 1));
        found = true;
      }
    }
    return !found || sink_.wants_more();
  }

  // Negative where the ray runs along the plane.
  double cross(const Vec3& normal, const Vec3& point) const {
    const double along = dot(normal, ray_.direction);
    if (std::abs(along) <= kGeometryEpsilon) return -1;
    return dot(normal, point - ray_.origin) / along;
  }
  void local(double depth, int x, int z, double& s, double& t) const {
    s = ray_.origin.x + depth * ray_.direction.x - x;
    t = ray_.origin.z + depth * ray_.direction.z - z;
  }
  uint32_t part(int x, int z, uint32_t upper) const {
    return 2 * (static_cast<uint32_t>(z) * static_cast<uint32_t>(grid_.columns()) +
                static_cast<uint32_t>(x)) +
           upper;
  }

  const HeightGrid& grid_;
  const Ray ray_;
  double from_, to_;
  double inverse_x_, inverse_z_;
  Sink& sink_;
};

// The normals of a smooth height field's vertices, each worked out when it is first asked for. Threads that
// ask at once find the same.
class VertexNormals {
 public:
  explicit VertexNormals(std::shared_ptr<const HeightGrid> grid)
      : grid_(std::move(grid)),
        known_(static_cast<size_t>(grid_->columns()) * static_cast<size_t>(grid_->rows())) {}

  // In steps of 1/32767.
  Vec3 at(int x, int z) const {
    std::atomic<uint64_t>& known =
        known_[static_cast<size_t>(z) * static_cast<size_t>(grid_->columns()) +
               static_cast<size_t>(x)];
    uint64_t packed = known.load(std::memory_order_relaxed);
    if (!packed) {
      packed = kIsKnown;
      const Vec3 normal = mean_of_triangles(x, z);
      for (int axis = 0; axis < 3; ++axis) {
        packed |= uint64_t{static_cast<uint16_t>(static_cast<int16_t>(normal[axis]))} << 16 * axis;
      }
      known.store(packed, std::memory_order_relaxed);
    }
    const auto component = [&](int axis) {
      return static_cast<double>(static_cast<int16_t>(packed >> 16 * axis));
    };
    return {component(0), component(1), component(2)};
  }

 private:
  static constexpr uint64_t kIsKnown = uint64_t{1} << 48;

  // Of those that a vertex spans with its neighbours along the axes.
  Vec3 mean_of_triangles(int x, int z) const {
    const bool left = x > 0, right = x < grid_->columns() - 1;
    const bool below = z > 0, above = z < grid_->rows() - 1;
    const double h = grid_->height(x, z);
    const double to_left = left ? grid_->height(x - 1, z) - h : 0;
    const double to_right = right ? h - grid_->height(x + 1, z) : 0;
    const double to_below = below ? grid_->height(x, z - 1) - h : 0;
    const double to_above = above ? h - grid_->height(x, z + 1) : 0;
    Vec3 sum(0);
    const auto add = [&](double nx, double nz) {
      const Vec3 n(nx, 1, nz);
      sum += n / length(n);
    };
    if (right && above) add(to_right, to_above);
    if (left && above) add(to_left, to_above);
    if (left && below) add(to_left, to_below);
    if (right && below) add(to_right, to_below);
    sum /= length(sum);
    return glm::trunc(32767.0 * sum);
  }

  std::shared_ptr<const HeightGrid> grid_;
  mutable std::vector<std::atomic<uint64_t>> known_;  // 0: not yet
};

class HeightField final : public Shape {
 public:
  HeightField(std::shared_ptr<const HeightGrid> grid, double water_level, bool smooth)
      : grid_(std::move(grid)) {
    if (smooth) normals_ = std::make_shared<const VertexNormals>(grid_);
    const double width = grid_->columns() - 1, depth = grid_->rows() - 1;
    low_ = {0, std::max<double>(grid_->least(), 65536 * water_level) - kBoxMargin, 0};
    high_ = {width, grid_->greatest() + kBoxMargin, depth};
    placed_ = Transform::scaling({1 / width, 1.0 / 65536, 1 / depth});
  }

  // In single precision in the grid, as POV-Ray keeps it (measured on povray 3.7).
  Bounds bounds() const override {
    const auto rounded = [](double v) { return static_cast<double>(static_cast<float>(v)); };
    const double low = rounded(low_.y), height = rounded(high_.y - low_.y);
    return placed_.bounds({{0, low, 0}, {high_.x, low + height, high_.z}});
  }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    struct Sink {
      HitStack& out;
      bool all;
      void push(double t, uint32_t part) { out.push(t, part); }
      bool wants_more() const { return all; }
    } sink{out, ray.csg_child};
    walk(ray, sink);
  }

  bool closest(const ShapeRay& ray, HitStack&, ShapeHit& hit) const override {
    // Without CSG the walk ends at the first cell that is hit, even too near.
    struct Sink {
      double best;
      ShapeHit& hit;
      bool all;
      bool found = false;
      void push(double t, uint32_t part) {
        if (t < kLeastHitDepth || t > best || (t == best && !found)) return;
        best = t;
        hit.t = t;
        hit.part = part;
        found = true;
      }
      bool wants_more() const { return all; }
    } sink{ray.t_max, hit, ray.csg_child};
    walk(ray, sink);
    return sink.found;
  }

  bool is_solid_within_bounds() const override { return false; }  // there is no floor
  bool inside(const Vec3& world_point) const override {
    const Vec3 p = placed_.inverse_point(world_point);
    if (!(p.x >= 0 && p.x < grid_->columns() - 1 && p.z >= 0 && p.z < grid_->rows() - 1 &&
          p.y < high_.y)) {
      return false;
    }
    if (p.y < low_.y) return true;
    const int x = static_cast<int>(p.x), z = static_cast<int>(p.z);
    const auto height = [&](int i, int j) {
      return std::max<double>(grid_->height(x + i, z + j), low_.y);
    };
    const double s = p.x - x, t = p.z - z;
    const double h2 = height(1, 0), h3 = height(0, 1);
    if (s + t <= 1) {
      const double h1 = height(0, 0);
      return p.y < h1 + s * (h2 - h1) + t * (h3 - h1);
    }
    const double h4 = height(1, 1);
    return p.y < h4 + (1 - s) * (h3 - h4) + (1 - t) * (h2 - h4);
  }

  Vec3 normal(const Vec3& world_point, const ShapeHit& hit) const override {
    const int cell = static_cast<int>(hit.part / 2);
    const int x = cell % grid_->columns(), z = cell / grid_->columns();
    if (!normals_) {
      const double h2 = grid_->height(x + 1, z), h3 = grid_->height(x, z + 1);
      if (hit.part % 2) {
        const double h4 = grid_->height(x + 1, z + 1);
        return placed_.normal({h3 - h4, 1, h2 - h4});
      }
      const double h1 = grid_->height(x, z);
      return placed_.normal({h1 - h2, 1, h1 - h3});
    }
    const Vec3 p = placed_.inverse_point(world_point);
    const double s = p.x - x, t = p.z - z;
    const auto corner = [&](int i, int j) {
      return unit_or_zero(placed_.normal(normals_->at(x + i, z + j)));
    };
    return (1 - t) * ((1 - s) * corner(0, 0) + s * corner(1, 0)) +
           t * ((1 - s) * corner(0, 1) + s * corner(1, 1));
  }

  std::shared_ptr<const Shape> transformed(const Transform& transform) const override {
    auto moved = std::make_shared<HeightField>(*this);
    moved->placed_ = placed_.then(transform);
    return moved;
  }

 private:
  template <typename Sink>
  void walk(const ShapeRay& ray, Sink& sink) const {
    ShapeRay local = ray;
    local.origin = placed_.inverse_point(ray.origin);
    local.direction = placed_.inverse_direction(ray.direction);
    BoxCrossing crossing;
    if (!cross_box(low_, high_, local, crossing)) return;
    const double from = std::max(crossing.near, kLeastDepth);
    const double to = std::min(crossing.far, ray.csg_child ? kHugeDepth : ray.t_max);
    if (!(from <= to)) return;
    Walk<Sink>(*grid_, {local.origin, local.direction}, from, to, sink).run();
  }

  std::shared_ptr<const HeightGrid> grid_;
  std::shared_ptr<const VertexNormals> normals_;  // null: not smooth
  Vec3 low_, high_;
  Transform placed_;  // from grid space
};

}  // namespace

PlacedShape compile(const HeightFieldNode& node, const ShapeContext&) {
  auto grid = std::make_shared<const HeightGrid>(*node.image);
  // A single row of heights makes no surface.
  if (grid->columns() < 2 || grid->rows() < 2) return {};
  return {std::make_shared<HeightField>(std::move(grid), node.water_level, node.smooth), false, {}};
}

}  // namespace durer
