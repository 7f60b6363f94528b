// Triangles in Embree, which finds candidates in single precision; its ROBUST mode is compulsory:
// without it rays leak through shared edges (performance.md 4).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/math/bounds.h"

namespace durer {

using TriangleVisitor = void (*)(void* context, uint32_t face);

class EmbreeMesh {
 public:
  // The faces lie within `bounds`.
  EmbreeMesh(const std::vector<glm::vec3>& vertices,
             const std::vector<std::array<int32_t, 3>>& faces, const Bounds& bounds);
  ~EmbreeMesh();

  // The face that Embree finds nearest between two depths along a unit direction. Its depth is
  // good to single precision only: compute it anew.
  bool nearest(const Vec3& origin, const Vec3& direction, double min_depth, double max_depth,
               uint32_t& face) const;
  // Every face that the ray meets, in no particular order.
  void visit_all(const Vec3& origin, const Vec3& direction, double max_depth,
                 TriangleVisitor visitor, void* context) const;

 private:
  struct Scene;
  // Moves a far origin to the mesh's bounds; false: the ray misses them.
  bool approach(const Vec3& origin, const Vec3& direction, double& advance) const;

  std::unique_ptr<Scene> scene_;
  Bounds bounds_;
  Vec3 center_{0};
};

}  // namespace durer
