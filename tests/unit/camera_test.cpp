#include "tracer/cameras/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace durer {
namespace {

Ray ray_at(const CameraNode& node, double x, double y) {
  Ray ray;
  EXPECT_TRUE(Camera(node, 100, 100, TextureSettings{}).generate_ray(x, y, 0, ray));
  return ray;
}

// spec/shading.md 19: a 4x4 picture, the ray of pixel column 2, row 1.
TEST(Camera, NormalBendsTheRayAsInTheSpecification) {
  CameraNode node;
  node.right = {1, 0, 0};
  auto normal = std::make_shared<NormalNode>();
  normal->pattern.edit().kind = PatternKind::gradient;
  normal->pattern.edit().gradient = {1, 0, 0};
  normal->bump_size = 0.3f;
  node.normal = normal;
  Ray ray;
  ASSERT_TRUE(Camera(node, 4, 4, TextureSettings{}).generate_ray(2.5, 1.5, 0, ray));
  EXPECT_NEAR(ray.direction.x, 0.0834, 5e-5);
  EXPECT_NEAR(ray.direction.y, 0.1236, 5e-5);
  EXPECT_NEAR(ray.direction.z, 0.9888, 5e-5);
}

TEST(Camera, RoundPicturesHaveNoRaysOutside) {
  CameraNode node;
  node.kind = CameraKind::fisheye;
  node.angle = 180;
  node.right = {1, 0, 0};
  const Camera camera(node, 100, 100, TextureSettings{});
  Ray ray;
  EXPECT_FALSE(camera.generate_ray(0.5, 0.5, 0, ray));
  ASSERT_TRUE(camera.generate_ray(100, 50, 0, ray));
  EXPECT_NEAR(ray.direction.x, 1, 1e-12);
}

TEST(Camera, LensRaysMeetInTheFocalPlane) {
  CameraNode node;
  node.location = {1, 2, 3};
  node.direction = {0, 0, 2};
  node.aperture = 0.5;
  node.blur_samples = 10;
  node.focal_distance = 7;
  const Camera camera(node, 100, 100, TextureSettings{});
  Ray straight, left, below;
  ASSERT_TRUE(camera.generate_ray(20, 70, 0, straight));
  ASSERT_TRUE(camera.generate_lens_ray(20, 70, {-0.4, 0}, left));
  ASSERT_TRUE(camera.generate_lens_ray(20, 70, {0, 0.4}, below));
  EXPECT_NEAR(left.origin.x, 1 - 0.4 * 0.25, 1e-12);
  EXPECT_NEAR(below.origin.y, 2 - 0.4 * 0.25, 1e-12);
  const auto in_focus = [](const Ray& ray) {
    return ray.at((10 - ray.origin.z) / ray.direction.z);
  };
  EXPECT_NEAR(length(in_focus(left) - in_focus(straight)), 0, 1e-12);
  EXPECT_NEAR(length(in_focus(below) - in_focus(straight)), 0, 1e-12);
}

TEST(Camera, DirectionsAreUnitVectorsForEveryKind) {
  for (int kind = 0; kind < static_cast<int>(CameraKind::mesh); ++kind) {
    CameraNode node;
    node.kind = static_cast<CameraKind>(kind);
    node.angle = 100;
    node.direction = {0.1, 0.2, 3};
    const Ray ray = ray_at(node, 47, 55);
    EXPECT_NEAR(length(ray.direction), 1, 1e-12) << kind;
  }
}

// Two triangles: a mesh camera's row 0 and row 1 show the same faces (spec/shading.md 3.4).
TEST(MeshCamera, StartsAtTheFacesOfTheMesh) {
  MeshNode mesh;
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {3, 3, 0}};
  mesh.face_vertices = {{0, 1, 2}, {1, 3, 2}};
  auto shape = std::make_shared<ShapeNode>(mesh);
  auto object = std::make_shared<ObjectNode>();
  object->shape = shape;
  object->modifiers.push_back(Transform::translation({0, 0, 5}));
  CameraNode node;
  node.kind = CameraKind::mesh;
  node.location = {0, 0, 0.5};
  node.mesh_objects = {object};
  const Camera camera(node, 2, 4, TextureSettings{});
  Ray ray;
  for (const double y : {0.5, 1.5}) {
    ASSERT_TRUE(camera.generate_ray(0.5, y, 0, ray));
    EXPECT_NEAR(length(ray.origin - Vec3(1, 1, 4.5)), 0, 1e-6) << y;
    EXPECT_NEAR(length(ray.direction - Vec3(0, 0, -1)), 0, 1e-6) << y;
    ASSERT_TRUE(camera.generate_ray(1.5, y, 0, ray));
    EXPECT_NEAR(length(ray.origin - Vec3(2, 2, 4.5)), 0, 1e-6) << y;
  }
  EXPECT_FALSE(camera.generate_ray(0.5, 2.5, 0, ray));
}

}  // namespace
}  // namespace durer
