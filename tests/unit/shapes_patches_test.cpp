// Triangles, polygons, discs, meshes, patches and height fields, against brute force.
#include "tests/unit/shape_rays.h"

namespace durer {
namespace {

// Of every ray: the nearest crossing of any of some triangles, by solving for it outright.
struct Corner {
  Vec3 a, b, c;
};

double nearest(const std::vector<Corner>& triangles, const Vec3& o, const Vec3& d, double& margin) {
  double best = HUGE_VAL;
  margin = HUGE_VAL;
  for (const Corner& t : triangles) {
    const Vec3 e1 = t.b - t.a, e2 = t.c - t.a, n = cross(e1, e2);
    const double along = dot(n, d);
    if (std::abs(along) < 1e-12) continue;
    const double depth = dot(n, t.a - o) / along;
    if (depth < 1e-3) continue;
    const Vec3 p = o + depth * d - t.a;
    const double size = dot(n, n);
    const double u = dot(cross(p, e2), n) / size, v = dot(cross(e1, p), n) / size;
    const double edge = std::min({u, v, 1 - u - v});
    if (std::abs(edge) < 1e-6) margin = 0;
    if (edge < 0) continue;
    best = std::min(best, depth);
  }
  return best;
}

void expect_triangles(const ShapeCase& shape, const std::vector<Corner>& triangles) {
  SCOPED_TRACE(shape.name);
  const auto query = query_of(shape);
  ASSERT_TRUE(query);
  RaySource source(*query);
  int hits = 0;
  for (int i = 0; i < 1500; ++i) {
    const RaySource::Sample ray = source.next();
    double margin;
    const double expected = nearest(triangles, ray.origin, ray.direction, margin);
    if (margin == 0) continue;  // an edge: either side is right
    Vec3 point, normal;
    const bool hit = query->trace(ray.origin, ray.direction, point, normal);
    const double depth = hit ? dot(point - ray.origin, ray.direction) : HUGE_VAL;
    if (depth < 1e-3) continue;  // the point from which it starts
    ASSERT_EQ(hit, expected < HUGE_VAL)
        << i << ' ' << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << " / "
        << ray.direction.x << ' ' << ray.direction.y << ' ' << ray.direction.z;
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(depth, expected, 1e-6);
  }
  EXPECT_GT(hits, 100);
}

const Vec3 kA(-0.8, -0.7, 0.1), kB(0.8, -0.5, -0.2), kC(0.1, 0.8, 0.3);

TEST(ShapesAgainstBruteForce, Triangles) {
  expect_triangles({"triangle", "triangle { <-0.8,-0.7,0.1>, <0.8,-0.5,-0.2>, <0.1,0.8,0.3> }", {}},
                   {{kA, kB, kC}});
  expect_triangles({"smooth_triangle",
                    "smooth_triangle { <-0.8,-0.7,0.1>, <1,0,-3>, <0.8,-0.5,-0.2>, <0,1,-3>, "
                    "<0.1,0.8,0.3>, <-1,0,-2> }", {}},
                   {{kA, kB, kC}});
  const Vec3 s(0.5, 1.2, 2);
  expect_triangles({"scaled by transform",
                    "smooth_triangle { <-0.8,-0.7,0.1>, <0.1,0,-3>, <0.8,-0.5,-0.2>, <0,0.1,-3>, "
                    "<0.1,0.8,0.3>, <-0.1,0,-2> transform { scale <0.5, 1.2, 2> } }", {}},
                   {{kA * s, kB * s, kC * s}});
}

// Normals on both sides of the triangle: never hit (geometry.md 13.2).
TEST(ShapesAgainstBruteForce, SmoothTrianglesWithOpposedNormalsAreNeverHit) {
  const auto query = query_of({"opposed", "smooth_triangle { -x, -z, x, -z, y, z }", {}});
  ASSERT_TRUE(query);
  Vec3 point, normal;
  EXPECT_FALSE(query->trace({0, 0.3, -3}, {0, 0, 1}, point, normal));
}

TEST(ShapesAgainstBruteForce, Polygons) {
  const Vec3 a(-0.7, -0.7, 0.2), b(0.7, -0.7, 0.2), c(0.7, 0.1, 0.2), d(0, 0.1, 0.2), e(0, 0.8, 0.2),
      f(-0.7, 0.8, 0.2);
  expect_triangles({"polygon",
                    "polygon { 7, <-0.7,-0.7>, <0.7,-0.7>, <0.7,0.1>, <0,0.1>, <0,0.8>, <-0.7,0.8>, "
                    "<-0.7,-0.7> translate 0.2*z }", {}},
                   {{a, b, c}, {a, c, d}, {a, d, f}, {d, e, f}});
}

TEST(ShapesAgainstBruteForce, Meshes) {
  // Vertices of a mesh are kept in single precision.
  const auto vertex = [](double x, double y, double z) {
    return Vec3(static_cast<double>(static_cast<float>(x)), static_cast<double>(static_cast<float>(y)),
                static_cast<double>(static_cast<float>(z)));
  };
  const Vec3 x = vertex(0.9, 0, 0), y = vertex(0, 0.8, 0), z = vertex(0, 0, 0.7);
  std::vector<Corner> octahedron;
  for (int i = 0; i < 8; ++i) {
    octahedron.push_back({i & 1 ? -x : x, i & 2 ? -y : y, i & 4 ? -z : z});
  }
  expect_triangles({"mesh2",
                    "mesh2 { vertex_vectors { 6, 0.9*x, -0.9*x, 0.8*y, -0.8*y, 0.7*z, -0.7*z } "
                    "face_indices { 8, <0,2,4>, <2,1,4>, <1,3,4>, <3,0,4>, <0,2,5>, <2,1,5>, <1,3,5>, "
                    "<3,0,5> } inside_vector <0.3, 0.5, 0.1> }", {}},
                   octahedron);
  expect_shape_agrees({"octahedron",
                       "mesh2 { vertex_vectors { 6, 0.9*x, -0.9*x, 0.8*y, -0.8*y, 0.7*z, -0.7*z } "
                       "face_indices { 8, <0,2,4>, <2,1,4>, <1,3,4>, <3,0,4>, <0,2,5>, <2,1,5>, "
                       "<1,3,5>, <3,0,5> } inside_vector <0.3, 0.5, 0.1> }",
                       [](const Vec3& p) {
                         return std::abs(p.x) / 0.9 + std::abs(p.y) / 0.8 + std::abs(p.z) / 0.7 - 1;
                       }, true, 1e-6});
}

TEST(ShapesAgainstBruteForce, Discs) {
  const ShapeCase shape{"disc", "disc { <0.1, 0, 0.1>, <1, 2, 0.5>, 0.8, 0.3 }", {}, false};
  const auto query = query_of(shape);
  ASSERT_TRUE(query);
  const Vec3 center(0.1, 0, 0.1), axis = Vec3(1, 2, 0.5) / length(Vec3(1, 2, 0.5));
  RaySource source(*query);
  int hits = 0;
  for (int i = 0; i < 1500; ++i) {
    const RaySource::Sample ray = source.next();
    if (ray.from_surface) continue;
    const double along = dot(axis, ray.direction);
    if (std::abs(along) < 1e-6) continue;
    const double depth = dot(axis, center - ray.origin) / along;
    const double radius = length(ray.origin + depth * ray.direction - center);
    if (std::min(std::abs(radius - 0.8), std::abs(radius - 0.3)) < 1e-6 || depth < 1e-3) continue;
    Vec3 point, normal;
    const bool hit = query->trace(ray.origin, ray.direction, point, normal);
    ASSERT_EQ(hit, radius > 0.3 && radius < 0.8) << i;
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(dot(point - ray.origin, ray.direction), depth, 1e-8);
  }
  EXPECT_GT(hits, 100);
}

TEST(ShapesAgainstBruteForce, HeightFields) {
  // Two by two points make one cell of two triangles; heights are kept in 16 bits.
  const auto height = [](double h) { return std::floor(h * 65535) / 65536; };
  const double h00 = height(0.2), h10 = height(0.6), h01 = height(0.5), h11 = height(0.9);
  // Row 0 of the function is the far end of z.
  const Vec3 shift(-0.5, -0.4, -0.5);
  const Vec3 a = Vec3(0, h01, 0) + shift, b = Vec3(1, h11, 0) + shift, c = Vec3(0, h00, 1) + shift,
             d = Vec3(1, h10, 1) + shift;
  expect_triangles({"height_field",
                    "height_field { function 2, 2 { 0.2 + 0.4*x + 0.3*y } translate <-0.5, -0.4, -0.5> }",
                    {}, false},
                   {{a, b, c}, {d, c, b}});
}

}  // namespace
}  // namespace durer
