#include "parser/world_queries.h"

#include "parser/parser.h"
#include "tracer/patterns/noise.h"
#include "tracer/scene/not_supported.h"
#include "tracer/scene/object.h"

namespace durer {
namespace {

class WorldQueries : public SceneQueries {
 public:
  explicit WorldQueries(const Parser& parser) : parser_(parser) {}

  bool trace(const ObjectPtr& object, const Vec3&, const Vec3&, Vec3&, Vec3&) override {
    throw NotSupported("trace()", object->position);
  }
  bool inside(const ObjectPtr& object, const Vec3&) override {
    throw NotSupported("inside()", object->position);
  }
  bool has_inside(const ObjectPtr&) override { return true; }
  Bounds extents(const ObjectPtr& object) override {
    throw NotSupported("min_extent() and max_extent()", object->position);
  }
  bool image_size(const PigmentNode&, Vec2&) override {
    throw NotSupported("max_extent() of a pigment", parser_.position());
  }
  Vec3 turbulence(const Vec3& point, double lambda, double omega, int octaves, int) override {
    return vector_turbulence(point, octaves, omega, lambda);
  }

 private:
  const Parser& parser_;
};

}  // namespace

std::shared_ptr<SceneQueries> make_world_queries(const Parser& parser) {
  return std::make_shared<WorldQueries>(parser);
}

}  // namespace durer
