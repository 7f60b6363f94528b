#include "tracer/cameras/mesh_camera.h"

#include <algorithm>
#include <cmath>

#include "tracer/shapes/triangle.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

// All transforms of the object and of what it copies, in the order of the text.
Transform placement_of(const ObjectNode& object) {
  Transform placement = object.base ? placement_of(*object.base) : Transform{};
  for (const Modifier& modifier : object.modifiers) {
    if (const auto* transform = std::get_if<Rare<Transform>>(&modifier)) {
      placement = placement.then(*transform);
    }
  }
  return placement;
}

std::shared_ptr<const ShapeNode> shared_shape_of(const ObjectNode& object) {
  return object.base ? shared_shape_of(*object.base) : object.shape;
}

struct Corners {
  Vec3 p[3];
  Vec3 normal;  // unit, single precision
};

Corners corners_of(const MeshNode& mesh, int64_t face) {
  Corners c;
  for (int i = 0; i < 3; ++i) c.p[i] = Vec3(mesh.vertices[mesh.face_vertices[face][i]]);
  c.normal = Vec3(mesh.face_planes.empty() ? mesh_plane_of(c.p[0], c.p[1], c.p[2]).normal
                                           : mesh.face_planes[static_cast<size_t>(face)].normal);
  return c;
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x * b.y - a.y * b.x;
}

// The shares of a triangle's corners at a point of its plane; false outside. Each is worked out by
// itself: on an upright or level edge it is exactly 0, whatever the others are.
bool corner_shares(const Vec2 corner[3], const Vec2& p, double share[3]) {
  const double area = cross(corner[1] - corner[0], corner[2] - corner[0]);
  if (area == 0) return false;
  const Vec2 to[3] = {corner[0] - p, corner[1] - p, corner[2] - p};
  for (int i = 0; i < 3; ++i) share[i] = cross(to[(i + 1) % 3], to[(i + 2) % 3]) / area;
  return share[0] >= 0 && share[1] >= 0 && share[2] >= 0;
}

bool uv_corners(const MeshNode& mesh, size_t face, Vec2 corner[3]) {
  if (face >= mesh.face_uv.size() || mesh.face_uv[face][0] < 0) return false;
  for (int i = 0; i < 3; ++i) corner[i] = mesh.uv[mesh.face_uv[face][i]];
  return true;
}

}  // namespace

MeshCamera::MeshCamera(const CameraNode& node, int width, int height)
    : distribution_(node.distribution),
      smooth_(node.mesh_smooth),
      width_(width),
      height_(height),
      offset_(node.location.z),
      reversed_(node.direction.z < -kEpsilon) {
  for (const ObjectPtr& object : node.mesh_objects) {
    std::shared_ptr<const ShapeNode> shape = shared_shape_of(*object);
    const MeshNode* mesh = &std::get<Rare<MeshNode>>(*shape).get();
    face_count_ += static_cast<int64_t>(mesh->face_vertices.size());
    meshes_.push_back({std::move(shape), mesh, placement_of(*object)});
  }
  if (distribution_ == 3) sort_faces_by_uv();
}

void MeshCamera::sort_faces_by_uv() {
  const MeshNode& mesh = *meshes_.front().mesh;
  for (size_t face = 0; face < mesh.face_vertices.size(); ++face) {
    Vec2 corner[3];
    if (!uv_corners(mesh, face, corner)) continue;
    const auto cell_range = [&](int axis, int& first, int& last) {
      const auto [least, most] = std::minmax({corner[0][axis], corner[1][axis], corner[2][axis]});
      first = static_cast<int>(std::clamp(least * kCells, 0.0, 1.0 * kCells));
      last = static_cast<int>(std::clamp(most * kCells, -1.0, kCells - 1.0));
    };
    int left, right, low, high;
    cell_range(0, left, right);
    cell_range(1, low, high);
    for (int v = low; v <= high; ++v) {
      for (int u = left; u <= right; ++u) {
        faces_by_cell_[v * kCells + u].push_back(static_cast<int32_t>(face));
      }
    }
  }
}

bool MeshCamera::generate_ray(double x, double y, int ray_of_pixel, Ray& ray) const {
  // POV-Ray's rows are one too high here, and its last one is never used.
  const double px = std::clamp(x, 0.0, width_ - 1.0);
  const double py = std::clamp(y - 1, 0.0, height_ - 1.0);
  const int64_t column = static_cast<int64_t>(px), row = static_cast<int64_t>(py);
  switch (distribution_) {
    case 0:  // ray k leaves mesh k
      return ray_of_face(meshes_[ray_of_pixel], row * width_ + column, ray);
    case 1: {  // the faces of all meshes in a row
      int64_t face = row * width_ + column + ray_of_pixel * face_count_;
      for (const PlacedMesh& placed : meshes_) {
        const int64_t count = static_cast<int64_t>(placed.mesh->face_vertices.size());
        if (face < count) return ray_of_face(placed, face, ray);
        face -= count;
      }
      return false;
    }
    case 2: {  // the picture is cut into upright strips, one for each mesh
      const size_t count = meshes_.size();
      const double strip = static_cast<double>(width_) / static_cast<double>(count);
      const size_t mesh = std::min(static_cast<size_t>(px / strip), count - 1);
      return ray_of_face(meshes_[mesh], row * (width_ / static_cast<int64_t>(count)) + column, ray);
    }
    default:
      return ray_of_texture_place((px - 0.5) / width_, 1 - (py + 0.5) / height_, ray);
  }
}

bool MeshCamera::ray_of_face(const PlacedMesh& placed, int64_t face, Ray& ray) const {
  if (face >= static_cast<int64_t>(placed.mesh->face_vertices.size())) return false;
  const Corners c = corners_of(*placed.mesh, face);
  ray = finished_ray(placed, (c.p[0] + c.p[1] + c.p[2]) / 3.0, c.normal);
  return true;
}

bool MeshCamera::ray_of_texture_place(double u, double v, Ray& ray) const {
  const PlacedMesh& placed = meshes_.front();
  const MeshNode& mesh = *placed.mesh;
  const int cell_u = std::clamp(static_cast<int>(std::floor(u * kCells)), 0, kCells - 1);
  const int cell_v = std::clamp(static_cast<int>(std::floor(v * kCells)), 0, kCells - 1);
  for (const int32_t face : faces_by_cell_[cell_v * kCells + cell_u]) {
    Vec2 corner[3];
    double share[3];
    if (!uv_corners(mesh, face, corner) || !corner_shares(corner, {u, v}, share)) continue;
    const Corners c = corners_of(mesh, face);
    const Vec3 origin = share[0] * c.p[0] + share[1] * c.p[1] + share[2] * c.p[2];
    Vec3 normal = c.normal;
    const size_t index = static_cast<size_t>(face);
    if (smooth_ && index < mesh.face_normals.size() && mesh.face_normals[index][0] >= 0) {
      normal = Vec3(0);
      for (int i = 0; i < 3; ++i) {
        normal += share[i] * Vec3(mesh.normals[mesh.face_normals[index][i]]);
      }
    } else if (smooth_) {
      normal = Vec3(0, 1, 0);  // measured on povray 3.7
    }
    ray = finished_ray(placed, origin, normal);
    return true;
  }
  return false;
}

Ray MeshCamera::finished_ray(const PlacedMesh& placed, const Vec3& origin,
                             const Vec3& normal) const {
  const Vec3 start = origin + offset_ * normal;
  const Vec3 direction = reversed_ ? -normal : normal;
  return {placed.placement.point(start), normalize_or_zero(placed.placement.normal(direction))};
}

}  // namespace durer
