// Lathes, surfaces of revolution, prisms, sweeps and text, against brute force.
#include "tests/unit/shape_rays.h"

namespace durer {
namespace {

// Between the points (0.2,-0.8), (0.7,-0.3), (0.3,0.7), straight: an open shell.
double linear_lathe(const Vec3& p) {
  const double radius = p.y < -0.3 ? 0.2 + (p.y + 0.8) : 0.7 - 0.4 * (p.y + 0.3);
  return std::hypot(p.x, p.z) - radius;
}

double l_prism(const Vec3& p) {
  const bool in_l = p.x > -0.7 && p.z > -0.7 && p.x < 0.7 && p.z < 0.7 && !(p.x > 0 && p.z > 0);
  return in_l && p.y > -0.4 && p.y < 0.5 ? -1 : 1;
}

const ShapeCase kCases[] = {
    {"lathe", "lathe { linear_spline 5, <0, -0.8>, <0.5, -0.8>, <0.7, -0.3>, <0.3, 0.7>, <0, 0.7> }",
     {}, true, 1e-8, 0.01},
    {"lathe cubic",
     "lathe { cubic_spline 6, <0, -1>, <0, -0.8>, <0.6, -0.4>, <0.4, 0.3>, <0, 0.7>, <0, 0.9> }", {},
     true, 1e-8, 0.02},
    {"sor", "sor { 6, <0.1, -1>, <0.3, -0.8>, <0.7, -0.4>, <0.4, 0.2>, <0.5, 0.7>, <0.3, 0.9> }", {},
     true, 1e-8, 0.02},
    {"prism",
     "prism { -0.4, 0.5, 7, <-0.7,-0.7>, <0.7,-0.7>, <0.7,0>, <0,0>, <0,0.7>, <-0.7,0.7>, <-0.7,-0.7> }",
     {}, true, 1e-8, 0.01},
    {"prism cubic",
     "prism { cubic_spline -0.4, 0.5, 7, <-0.6,0.6>, <-0.6,-0.6>, <0.6,-0.6>, <0.6,0.6>, <-0.6,0.6>, "
     "<-0.6,-0.6>, <0.6,-0.6> }", {}, true, 1e-8, 0.02},
    {"prism conic",
     "prism { conic_sweep linear_spline 0.2, 0.9, 5, <-0.7,-0.7>, <0.7,-0.7>, <0.7,0.7>, <-0.7,0.7>, "
     "<-0.7,-0.7> }", {}, true, 1e-8, 0.02},
    {"text", "text { ttf \"timrom.ttf\" \"O\" 0.6, 0 translate <-0.4, -0.35, -0.3> scale 1.8 }", {},
     true, 1e-8, 0.01},
};

TEST(ShapesAgainstBruteForce, Swept) {
  for (const ShapeCase& shape : kCases) expect_shape_agrees(shape);
}

// Hits of open shells lie on them, and are where the profile says.
TEST(ShapesAgainstBruteForce, HitsOfALatheLieOnItsProfile) {
  const ShapeCase shape{"open lathe", "lathe { linear_spline 3, <0.2, -0.8>, <0.7, -0.3>, <0.3, 0.7> }",
                        {}, false};
  for_random_hits(shape, 600, 100, [&](const Vec3& point) {
    EXPECT_NEAR(linear_lathe(point), 0, 1e-8);
    EXPECT_GE(point.y, -0.8 - 1e-8);
    EXPECT_LE(point.y, 0.7 + 1e-8);
  });
}

// The inside of a prism is that of its outline.
TEST(ShapesAgainstBruteForce, InsideOfAPrism) {
  const auto query = query_of(kCases[3]);
  ASSERT_TRUE(query);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p(uniform(random), uniform(random), uniform(random));
    EXPECT_EQ(query->inside(p), l_prism(p) < 0);
  }
}

// A sweep of spheres along a line is where some sphere of it is.
TEST(ShapesAgainstBruteForce, HitsOfASphereSweepTouchASphere) {
  const ShapeCase shape{"sweep", "sphere_sweep { linear_spline 2, <-0.5, 0, 0>, 0.3, <0.6, 0.2, 0>, 0.2 }",
                        {}};
  const auto distance = [](const Vec3& p) {
    double least = HUGE_VAL;
    for (int i = 0; i <= 4000; ++i) {
      const double u = i / 4000.0;
      least = std::min(least, length(p - Vec3(-0.5 + 1.1 * u, 0.2 * u, 0)) - (0.3 - 0.1 * u));
    }
    return least;
  };
  for_random_hits(shape, 400, 50, [&](const Vec3& point) {
    EXPECT_NEAR(distance(point), 0, 1e-6);
  });
}

}  // namespace
}  // namespace durer
