// Isosurfaces, parametric surfaces and Julia sets, against brute force.
#include "tests/unit/shape_rays.h"

namespace durer {
namespace {

const ShapeCase kCases[] = {
    {"isosurface",
     "isosurface { function { x*x + 2*y*y*y*y + z*z - 0.5 } contained_by { sphere { 0, 1.2 } } "
     "max_gradient 9 accuracy 0.00001 }",
     [](const Vec3& p) { return p.x * p.x + 2 * p.y * p.y * p.y * p.y + p.z * p.z - 0.5; }, true, 2e-5,
     0.02},
    {"isosurface all_intersections",
     "isosurface { function { x*x + z*z - 0.3 - 0.2*sin(y*6) } contained_by { box { -0.9, 0.9 } } "
     "max_gradient 4 accuracy 0.00001 all_intersections }",
     {}, true, 1e-5, 0.03},
    {"julia_fractal",
     "julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 4 precision 300 }", {},
     true, 1e-6, 0.1},
};

TEST(ShapesAgainstBruteForce, Fields) {
  for (const ShapeCase& shape : kCases) expect_shape_agrees(shape);
}

// Hits of a parametric sphere lie on the sphere, up to its accuracy.
TEST(ShapesAgainstBruteForce, HitsOfAParametricSphere) {
  const ShapeCase shape{"parametric",
                        "parametric { function { 0.7*cos(u)*sin(v) } function { 0.7*sin(u)*sin(v) } "
                        "function { 0.7*cos(v) } <0, 0>, <2*pi, pi> contained_by { sphere { 0, 0.8 } } "
                        "accuracy 0.0001 }",
                        {}, false};
  for_random_hits(shape, 400, 100, [&](const Vec3& point) {
    EXPECT_NEAR(length(point), 0.7, 5e-3);  // patches end at the accuracy in u and v
  });
}

}  // namespace
}  // namespace durer
