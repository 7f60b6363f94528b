// What the language asks the tracer while it parses: trace(), inside(), extents, turbulence.
#pragma once

#include <memory>

#include "tracer/math/bounds.h"
#include "tracer/math/vector.h"

namespace durer {

struct ObjectNode;
struct PigmentNode;

class SceneQueries {
 public:
  virtual ~SceneQueries() = default;

  // Nearest hit along unit_direction, with the shape's raw unit normal. False: none.
  virtual bool trace(const std::shared_ptr<const ObjectNode>& object, const Vec3& origin,
                     const Vec3& unit_direction, Vec3& point, Vec3& normal) = 0;
  virtual bool inside(const std::shared_ptr<const ObjectNode>& object, const Vec3& point) = 0;
  // False for shapes without an inside (triangles, patches, open meshes).
  virtual bool has_inside(const std::shared_ptr<const ObjectNode>& object) = 0;
  // The box with POV-Ray's single-precision rounding (spec/language.md 8).
  virtual Bounds extents(const std::shared_ptr<const ObjectNode>& object) = 0;
  // Width and height in pixels. False: not an image_map pigment.
  virtual bool image_size(const PigmentNode& pigment, Vec2& size) = 0;
  // vturbulence(); octaves is already clamped to 1..10.
  virtual Vec3 turbulence(const Vec3& point, double lambda, double omega, int octaves,
                          int noise_generator) = 0;
};

}  // namespace durer
