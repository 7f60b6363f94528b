// Shapes against slow brute force: rays of every kind are stepped along with the shape's equation, or
// where it has none with its inside test, and compared with what trace() finds.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "tests/unit/parsed_text.h"
#include "tracer/world/world.h"

namespace durer {

// Negative inside; zero on the surface. In the space in which the statement was written.
using Implicit = std::function<double(const Vec3&)>;

struct ShapeCase {
  const char* name;
  const char* statement;    // of SDL
  Implicit implicit;        // empty: only the inside test is known
  bool is_closed = true;    // crossing the surface changes the inside
  double tolerance = 1e-8;  // of the equation at a hit, relative to its slope
  double lost_share = 0;    // of the rays whose hits the documented solvers lose (geometry.md 11)
  double least_depth = 1e-3;  // hits nearer to a ray's origin are not asked for
  double aside = 1e-4;        // this far from a hit the inside has changed
};

inline std::shared_ptr<const ObjectQuery> query_of(const ShapeCase& shape) {
  const ParsedText parsed =
      parse_text(std::string("#version 3.7; global_settings { assumed_gamma 1 } ") + shape.statement);
  EXPECT_TRUE(parsed.scene) << shape.name << ": " << parsed.error;
  if (!parsed.scene || parsed.scene->objects.empty()) return nullptr;
  return ObjectQuery::build(parsed.scene->objects.front(), 370);
}

// Random, axis-parallel, with one zero component, along the surface, from the surface.
class RaySource {
 public:
  explicit RaySource(const ObjectQuery& query) : query_(query) {}

  struct Sample {
    Vec3 origin, direction;
    bool from_surface = false;
  };

  Sample next() {
    const int kind = count_++ % 5;
    const Vec3 target = 0.9 * any();
    Sample ray{target, any(), false};
    if (kind == 1) {
      const int axis = count_ % 3;
      ray.direction = Vec3(0);
      ray.direction[axis] = count_ % 2 ? 1 : -1;
    } else if (kind == 2) {
      ray.direction[count_ % 3] = 0;
    }
    ray.direction /= length(ray.direction);
    ray.origin = target - 4.0 * ray.direction;
    Vec3 point, normal;
    if (kind < 3 || !query_.trace(ray.origin, ray.direction, point, normal)) return ray;
    ray.origin = point;
    ray.from_surface = true;
    ray.direction = any();
    if (kind == 3) {
      // Along the tangent plane, starting a little aside.
      ray.direction = cross(normal, ray.direction);
      ray.origin = point - 2.0 * ray.direction + (count_ % 2 ? 1e-3 : -1e-3) * normal;
      ray.from_surface = false;
    }
    ray.direction /= length(ray.direction);
    return ray;
  }

 private:
  Vec3 any() { return {uniform_(random_), uniform_(random_), uniform_(random_)}; }

  const ObjectQuery& query_;
  std::mt19937 random_{11};
  std::uniform_real_distribution<double> uniform_{-1, 1};
  int count_ = 0;
};

// Calls visit(point) for what random rays hit; at least `least` of them must.
inline void for_random_hits(const ShapeCase& shape, int rays, int least,
                            const std::function<void(const Vec3&)>& visit) {
  const auto query = query_of(shape);
  ASSERT_TRUE(query);
  RaySource source(*query);
  int hits = 0;
  for (int i = 0; i < rays; ++i) {
    const RaySource::Sample ray = source.next();
    Vec3 point, normal;
    if (!query->trace(ray.origin, ray.direction, point, normal)) continue;
    ++hits;
    visit(point);
  }
  EXPECT_GT(hits, least);
}

inline Vec3 slope_of(const Implicit& f, const Vec3& p) {
  constexpr double h = 1e-6;
  Vec3 slope;
  for (int i = 0; i < 3; ++i) {
    Vec3 step(0);
    step[i] = h;
    slope[i] = (f(p + step) - f(p - step)) / (2 * h);
  }
  return slope;
}

// The first change of sign of f along a ray within [from, to]; negative: none. Crossings closer to each
// other than a step are not seen.
inline double first_crossing(const std::function<bool(double)>& is_inside, double from, double to) {
  constexpr double kStep = 0.004;
  const bool start = is_inside(from);
  for (double t = from + kStep; t < to; t += kStep) {
    if (is_inside(t) == start) continue;
    double low = t - kStep, high = t;
    for (int i = 0; i < 50; ++i) {
      const double middle = (low + high) / 2;
      (is_inside(middle) == start ? low : high) = middle;
    }
    return high;
  }
  return -1;
}

inline void expect_shape_agrees(const ShapeCase& shape) {
  SCOPED_TRACE(shape.name);
  const auto query = query_of(shape);
  ASSERT_TRUE(query);
  RaySource source(*query);
  constexpr int kRays = 600;
  int hits = 0, wrong_points = 0, wrong_normals = 0, unchanged = 0, lost = 0, wrong_inside = 0;
  for (int i = 0; i < kRays; ++i) {
    const RaySource::Sample ray = source.next();
    const auto at = [&](double t) { return ray.origin + t * ray.direction; };
    Vec3 point, normal;
    const bool hit = query->trace(ray.origin, ray.direction, point, normal);
    const double depth = hit ? length(point - ray.origin) : HUGE_VAL;
    if (hit) {
      ++hits;
      const double facing = std::abs(dot(normal, ray.direction));
      if (shape.implicit) {
        const Vec3 slope = slope_of(shape.implicit, point);
        const double steepness = length(slope);
        wrong_points += std::abs(shape.implicit(point)) > shape.tolerance * (1 + steepness);
        // At edges and apexes there is no slope to compare with.
        wrong_normals += steepness > 1e-3 && std::abs(std::abs(dot(slope, normal)) / steepness - 1) > 1e-2;
      }
      if (shape.is_closed && facing > 0.05) {
        const Vec3 aside = shape.aside * ray.direction;
        unchanged += query->inside(point - aside) == query->inside(point + aside);
      }
    }
    // What the brute force sees must not be missed.
    if (shape.implicit || shape.is_closed) {
      const auto is_inside = [&](double t) {
        return shape.implicit ? shape.implicit(at(t)) < 0 : query->inside(at(t));
      };
      const double from = ray.from_surface ? 10 * shape.least_depth : shape.least_depth;
      const double seen = first_crossing(is_inside, from, 9);
      lost += seen > 0 && depth > seen + 1e-5;
    }
    if (shape.is_closed && shape.implicit) {
      const Vec3 p = at(2.5 + 0.005 * i);
      if (std::abs(shape.implicit(p)) > 1e-3) {
        wrong_inside += query->inside(p) != (shape.implicit(p) < 0);
      }
    }
  }
  EXPECT_GT(hits, kRays / 8);
  EXPECT_EQ(wrong_points, 0);
  EXPECT_LE(wrong_normals, hits / 50);  // edges, where either side's normal is right
  EXPECT_LE(unchanged, hits / 50);      // corners: both points beside the hit on one side
  EXPECT_LE(lost, shape.lost_share * kRays);
  EXPECT_EQ(wrong_inside, 0);
}

}  // namespace durer
