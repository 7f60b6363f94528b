// Tori, polynomials of higher order, blobs and superellipsoids, against brute force.
#include "tests/unit/shape_rays.h"

namespace durer {
namespace {

double torus(const Vec3& p) {
  return std::hypot(std::hypot(p.x, p.z) - 0.6, p.y) - 0.25;
}

double field(const Vec3& p, const Vec3& center, double radius, double strength) {
  const double r2 = dot(p - center, p - center) / (radius * radius);
  return r2 < 1 ? strength * (1 - r2) * (1 - r2) : 0;
}

const ShapeCase kCases[] = {
    // Near its tangents the quartic loses roots, as the reference's does.
    {"torus", "torus { 0.6, 0.25 }", torus, true, 1e-6, 0.02},
    {"torus sturm", "torus { 0.6, 0.25 sturm }", torus, true, 1e-8, 0.01},
    // Polynomials count as inside up to 1e-4 beyond their surface.
    {"cubic",
     "polynomial { 3, xyz(3,0,0): 1, xyz(2,0,1): 0.3, xyz(1,0,2): 0.2, xyz(1,0,0): -1, "
     "xyz(0,3,0): 0.5, xyz(0,1,2): 0.4, xyz(0,0,1): 0.1, xyz(0,0,0): -0.2 }",
     [](const Vec3& p) {
       return p.x * p.x * p.x + 0.3 * p.x * p.x * p.z + 0.2 * p.x * p.z * p.z - p.x +
              0.5 * p.y * p.y * p.y + 0.4 * p.y * p.z * p.z + 0.1 * p.z - 0.2;
     }, true, 1e-6, 0.01, 1e-3, 0.01},
    {"quartic", "polynomial { 4, xyz(4,0,0): 1, xyz(0,4,0): 2, xyz(0,0,4): 3, xyz(2,2,0): 0.5, xyz(0,0,0): -0.2 }",
     [](const Vec3& p) {
       return p.x * p.x * p.x * p.x + 2 * p.y * p.y * p.y * p.y + 3 * p.z * p.z * p.z * p.z +
              0.5 * p.x * p.x * p.y * p.y - 0.2;
     }, true, 1e-5, 0.02, 1e-3, 0.01},
    // From its own surface Sturm's method may take the origin for the only root.
    {"order six", "polynomial { 6, xyz(6,0,0): 1, xyz(0,6,0): 1, xyz(0,0,6): 1, xyz(0,0,0): -0.1 }",
     [](const Vec3& p) {
       return std::pow(p.x, 6) + std::pow(p.y, 6) + std::pow(p.z, 6) - 0.1;
     }, true, 1e-8, 0.08, 1e-3, 0.03},
    {"blob",
     "blob { threshold 0.4 sphere { <-0.3, 0, 0>, 0.8, 1 } sphere { <0.4, 0.1, 0>, 0.7, 0.9 } }",
     [](const Vec3& p) {
       return 0.4 - field(p, {-0.3, 0, 0}, 0.8, 1) - field(p, {0.4, 0.1, 0}, 0.7, 0.9);
     }, true, 1e-6, 0.02, 1.1e-2},
    {"superellipsoid", "superellipsoid { <0.5, 0.7> scale 0.8 }",
     [](const Vec3& q) {
       const Vec3 p = glm::abs(q / 0.8);
       const double ring = std::pow(p.x, 2 / 0.5) + std::pow(p.y, 2 / 0.5);
       return std::pow(ring, 0.5 / 0.7) + std::pow(p.z, 2 / 0.7) - 1;
     }, true, 1e-6, 0.01},
    {"ovus", "ovus { 0.6, 0.3 }", {}, true, 1e-8, 0.01},
};

TEST(ShapesAgainstBruteForce, Polynomials) {
  for (const ShapeCase& shape : kCases) expect_shape_agrees(shape);
}

}  // namespace
}  // namespace durer
