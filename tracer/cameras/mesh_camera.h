// mesh_camera { rays distribution [max_distance] mesh... [smooth] }: rays leave the faces of meshes
// (spec/shading.md 3.4).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/math/ray.h"
#include "tracer/math/transform.h"
#include "tracer/scene/camera.h"

namespace durer {

class MeshCamera {
 public:
  // `node` must be of kind mesh. Only the z components of its location and direction matter.
  MeshCamera(const CameraNode& node, int width, int height);

  // x, y in pixels, (0.5, 0.5) the centre of the top left one. False: no face belongs to this
  // place.
  bool generate_ray(double x, double y, int ray_of_pixel, Ray& ray) const;

 private:
  struct PlacedMesh {
    std::shared_ptr<const ShapeNode> shape;  // keeps `mesh` alive
    const MeshNode* mesh;
    Transform placement;
  };

  bool ray_of_face(const PlacedMesh& placed, int64_t face, Ray& ray) const;
  bool ray_of_texture_place(double u, double v, Ray& ray) const;
  Ray finished_ray(const PlacedMesh& placed, const Vec3& origin, const Vec3& normal) const;
  void sort_faces_by_uv();

  int distribution_;
  bool smooth_;
  int width_, height_;
  double offset_;  // how far from the face rays start
  bool reversed_;
  std::vector<PlacedMesh> meshes_;
  int64_t face_count_ = 0;  // of all meshes
  // Distribution 3: the faces that may cover each cell of a grid over the unit square of uv.
  static constexpr int kCells = 10;
  std::array<std::vector<int32_t>, kCells * kCells> faces_by_cell_;
};

}  // namespace durer
