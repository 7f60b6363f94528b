#include "parser/world_queries.h"

#include <unordered_map>

#include "parser/parser.h"
#include "tracer/image/raster_file.h"
#include "tracer/patterns/noise.h"
#include "tracer/scene/object.h"
#include "tracer/scene/texture.h"
#include "tracer/world/world.h"

namespace durer {
namespace {

class WorldQueries : public SceneQueries {
 public:
  explicit WorldQueries(const Parser& parser) : parser_(parser) {}

  bool trace(const ObjectPtr& object, const Vec3& origin, const Vec3& unit_direction, Vec3& point,
             Vec3& normal) override {
    return compiled(object).trace(origin, unit_direction, point, normal);
  }
  bool inside(const ObjectPtr& object, const Vec3& point) override {
    return compiled(object).inside(point);
  }
  bool has_inside(const ObjectPtr& object) override { return compiled(object).has_inside(); }
  Bounds extents(const ObjectPtr& object) override { return compiled(object).extents(); }
  bool image_size(const PigmentNode& pigment, Vec2& size) override {
    if (pigment.pattern->kind != PatternKind::image_map || !pigment.pattern->image) return false;
    const std::shared_ptr<const RasterFile> raster = raster_of(*pigment.pattern->image);
    size = {raster->width, raster->height};
    return true;
  }
  Vec3 turbulence(const Vec3& point, double lambda, double omega, int octaves, int) override {
    // POV-Ray keeps both in single precision.
    return vector_turbulence(point, octaves, static_cast<float>(omega), static_cast<float>(lambda));
  }

 private:
  // An object is compiled once, however often it is asked about (design.md rule 6).
  const ObjectQuery& compiled(const ObjectPtr& object) {
    Compiled& entry = compiled_[object.get()];
    if (!entry.query) {
      entry.object = object;
      entry.query = ObjectQuery::build(object, parser_.effective_version());
    }
    return *entry.query;
  }

  struct Compiled {
    ObjectPtr object;  // keeps the address from being used again
    std::shared_ptr<const ObjectQuery> query;
  };

  const Parser& parser_;
  std::unordered_map<const ObjectNode*, Compiled> compiled_;
};

}  // namespace

std::shared_ptr<SceneQueries> make_world_queries(const Parser& parser) {
  return std::make_shared<WorldQueries>(parser);
}

}  // namespace durer
