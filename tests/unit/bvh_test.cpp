// Walks through the hierarchy against asking every item.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <set>

#include "tracer/intersect/bvh_beam.h"
#include "tracer/intersect/bvh_walk.h"

namespace durer {
namespace {

// Spheres within their boxes, all over a cube of the given half side around a point.
struct Cloud {
  Cloud(int count, const Vec3& around, double half_side) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> place(-half_side, half_side), size(0.001, 0.03);
    std::vector<Bounds> boxes;
    for (int i = 0; i < count; ++i) {
      center.push_back(around + Vec3(place(random), place(random), place(random)));
      radius.push_back(size(random) * half_side);
      boxes.push_back({center[i] - Vec3(radius[i]), center[i] + Vec3(radius[i])});
    }
    bvh.build(boxes);
  }

  std::optional<double> meets(uint32_t item, const BvhRay& ray) const {
    const Vec3 offset = ray.origin - center[item];
    const double b = dot(offset, ray.direction);
    const double c = dot(offset, offset) - radius[item] * radius[item];
    const double discriminant = b * b - c;
    if (discriminant < 0) return std::nullopt;
    const double t = -b - std::sqrt(discriminant);
    return t > 0 ? std::optional(t) : std::nullopt;
  }
  double nearest_of_all(const BvhRay& ray, double t_max) const {
    for (uint32_t i = 0; i < center.size(); ++i) t_max = std::min(t_max, meets(i, ray).value_or(t_max));
    return t_max;
  }
  // For visit_ray() and visit_beam_ray().
  auto visitor(const BvhRay& ray, double& nearest) const {
    return [this, &ray, &nearest](uint32_t first, uint32_t count, double& t_max) {
      for (uint32_t i = first; i < first + count; ++i) {
        nearest = std::min(nearest, meets(bvh.items()[i], ray).value_or(nearest));
      }
      t_max = nearest;
      return false;
    };
  }

  std::vector<Vec3> center;
  std::vector<double> radius;
  Bvh bvh;
};

// A ray through a pixel-sized window, and its neighbours.
std::vector<Ray> bundle(const Vec3& eye, const Vec3& target, double spread, double lens,
                        std::mt19937_64& random) {
  std::uniform_real_distribution<double> aside(-1, 1);
  std::vector<Ray> rays;
  for (int i = 0; i < 9; ++i) {
    const Vec3 origin = eye + lens * Vec3(aside(random), aside(random), aside(random));
    const Vec3 through = target + spread * Vec3(aside(random), aside(random), aside(random));
    rays.push_back({origin, normalize(through - origin)});
  }
  return rays;
}

constexpr double kFar = 1e7;

TEST(Bvh, HoldsEachItemOnce) {
  for (const int count : {1, 2, 3, 12, 13, 1000}) {
    const Cloud cloud(count, Vec3(0), 1);
    const auto& items = cloud.bvh.items();
    EXPECT_EQ(items.size(), static_cast<size_t>(count));
    EXPECT_EQ(std::set<uint32_t>(items.begin(), items.end()).size(), items.size());
  }
}

TEST(Bvh, ItemsThatCannotBePartedAreAllMet) {
  for (const double apart : {0.0, 1e-42, 1e-12, 1e-3}) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < 100; ++i) {
      const Vec3 center(i % 2 ? apart : 0, 0, i % 3 ? apart : 0);
      boxes.push_back({center - Vec3(1), center + Vec3(1)});
    }
    Bvh bvh;
    bvh.build(boxes);
    std::set<uint32_t> met;
    bvh.visit_ray(BvhRay({0.2, 0.3, -5}, {0, 0, 1}), kFar,
                  [&](uint32_t first, uint32_t count, double&) {
                    for (uint32_t i = first; i < first + count; ++i) met.insert(bvh.items()[i]);
                    return false;
                  });
    EXPECT_EQ(met.size(), boxes.size()) << apart;
  }
}

TEST(Bvh, TheNearestIsFoundFromAnywhere) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-1, 1);
  for (const double distance : {0.0, 2.0, 1e5}) {
    const Vec3 around(3, -2, 5);
    const Cloud cloud(3000, around, 1);
    int met = 0;
    for (int i = 0; i < 300; ++i) {
      const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
      const Vec3 origin = around + point() + distance * normalize(point());
      const BvhRay ray(origin, normalize(around + point() - origin));
      double nearest = kFar;
      cloud.bvh.visit_ray(ray, kFar, cloud.visitor(ray, nearest));
      EXPECT_EQ(nearest, cloud.nearest_of_all(ray, kFar));
      met += nearest < kFar;
      double of_any_order = kFar;
      cloud.bvh.visit_ray<true>(ray, kFar, cloud.visitor(ray, of_any_order));
      EXPECT_EQ(nearest, of_any_order);
    }
    EXPECT_GT(met, 100);
  }
}

TEST(Bvh, ABeamFindsForEachRayWhatTheRayFinds) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> place(-1, 1);
  const Vec3 around(3, -2, 5);
  const Cloud cloud(20000, around, 1);
  int beams = 0, met = 0;
  for (const double spread : {0.0, 0.002, 0.05, 0.5}) {
    for (const double lens : {0.0, 0.05}) {
      for (int i = 0; i < 40; ++i) {
        const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
        const Vec3 eye = around + (i % 4 ? 3.0 : 0.5) * point();
        const std::vector<Ray> rays = bundle(eye, around + point(), spread, lens, random);
        BvhBeam beam;
        const double t_max = i % 3 ? kFar : 2;
        if (!cloud.bvh.make_beam(rays.data(), static_cast<int>(rays.size()), t_max, beam)) continue;
        ++beams;
        for (const Ray& each : rays) {
          const BvhRay ray(each.origin, each.direction);
          double nearest = t_max;
          cloud.bvh.visit_beam_ray(beam, ray, t_max, cloud.visitor(ray, nearest));
          EXPECT_EQ(nearest, cloud.nearest_of_all(ray, t_max));
          met += nearest < t_max;
        }
      }
    }
  }
  EXPECT_GT(beams, 150);
  EXPECT_GT(met, 500);
}

TEST(Bvh, NoBeamWhereRaysPartOrStandStill) {
  const Cloud cloud(20000, Vec3(0), 1);
  BvhBeam beam;
  const Ray left{Vec3(0, 0, -3), normalize(Vec3(-0.01, 0.2, 1))};
  const Ray right{Vec3(0, 0, -3), normalize(Vec3(0.01, 0.2, 1))};
  const Ray straight{Vec3(0, 0, -3), Vec3(0, 0, 1)};
  for (const auto& pair : {std::array{left, right}, std::array{straight, straight}}) {
    EXPECT_FALSE(cloud.bvh.make_beam(pair.data(), 2, kFar, beam));
  }
  // All pass by: a beam that meets nothing.
  const Ray away{Vec3(0, 0, -3), normalize(Vec3(0.1, 0.2, -1))};
  EXPECT_TRUE(cloud.bvh.make_beam(&away, 1, kFar, beam));
  EXPECT_EQ(beam.groups, 0);
}

}  // namespace
}  // namespace durer
