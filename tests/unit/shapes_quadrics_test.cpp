// Planes, boxes and what has a quadratic equation, against brute force.
#include "tests/unit/shape_rays.h"

namespace durer {
namespace {

double sphere(const Vec3& p, double radius) { return length(p) - radius; }

const ShapeCase kCases[] = {
    {"sphere", "sphere { <0.1, 0.2, -0.1>, 0.7 }",
     [](const Vec3& p) { return sphere(p - Vec3(0.1, 0.2, -0.1), 0.7); }},
    {"ellipsoid", "sphere { 0, 1 scale <0.9, 0.5, 0.7> }",
     [](const Vec3& p) { return sphere(p / Vec3(0.9, 0.5, 0.7), 1); }},
    {"box", "box { <-0.6, -0.5, -0.7>, <0.5, 0.8, 0.4> }",
     [](const Vec3& p) {
       const Vec3 low = Vec3(-0.6, -0.5, -0.7) - p, high = p - Vec3(0.5, 0.8, 0.4);
       return std::max({low.x, low.y, low.z, high.x, high.y, high.z});
     }},
    {"cylinder", "cylinder { -0.7*y, 0.6*y, 0.5 }",
     [](const Vec3& p) {
       return std::max({std::hypot(p.x, p.z) - 0.5, p.y - 0.6, -0.7 - p.y});
     }},
    {"open cylinder", "cylinder { -0.7*z, 0.6*z, 0.5 open }",
     {}, false},
    {"cone", "cone { -0.6*y, 0.8, 0.7*y, 0.2 }",
     [](const Vec3& p) {
       const double radius = 0.8 + (p.y + 0.6) / 1.3 * (0.2 - 0.8);
       return std::max({std::hypot(p.x, p.z) - radius, p.y - 0.7, -0.6 - p.y});
     }},
    {"plane", "plane { <1, 2, 3>, 0.2 }",
     [](const Vec3& p) { return dot(p, Vec3(1, 2, 3)) / std::sqrt(14.0) - 0.2; }},
    {"quadric ellipsoid", "quadric { <2, 3, 4>, <0.3, 0, 0.2>, <0, 0.1, 0>, -1 }",
     [](const Vec3& p) {
       return 2 * p.x * p.x + 3 * p.y * p.y + 4 * p.z * p.z + 0.3 * p.x * p.y + 0.2 * p.y * p.z +
              0.1 * p.y - 1;
     }},
    {"quadric hyperboloid", "quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, -0.2 }",
     [](const Vec3& p) { return p.x * p.x - p.y * p.y + p.z * p.z - 0.2; }},
    {"rotated box", "box { -0.5, 0.5 rotate <20, 30, 40> }", {}},
    {"sheared cylinder",
     "cylinder { -0.6*y, 0.6*y, 0.5 matrix <1, 0.2, 0, 0.3, 1, 0, 0, 0.1, 1, 0.1, 0, 0> }", {}},
};

TEST(ShapesAgainstBruteForce, Quadrics) {
  for (const ShapeCase& shape : kCases) expect_shape_agrees(shape);
}

}  // namespace
}  // namespace durer
