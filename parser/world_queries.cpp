#include "parser/world_queries.h"

#include <algorithm>
#include <unordered_map>

#include "parser/parser.h"
#include "tracer/image/raster_file.h"
#include "tracer/patterns/noise.h"
#include "tracer/scene/object.h"
#include "tracer/scene/texture.h"
#include "tracer/world/compiled_shapes.h"
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
    std::shared_ptr<const ObjectQuery>& query = compiled_[object];
    if (!query) {
      query = ObjectQuery::build(object, parser_.effective_version(), shapes_);
      if (compiled_.size() >= sweep_at_) forget_unused();
    }
    return *query;
  }
  // Loops ask about thousands of objects that nobody else has afterwards.
  void forget_unused() {
    std::erase_if(compiled_, [](const auto& entry) { return entry.first.use_count() == 1; });
    sweep_at_ = std::max<size_t>(kFewQueries, 2 * compiled_.size());
  }

  static constexpr size_t kFewQueries = 64;
  const Parser& parser_;
  CompiledShapes shapes_;
  std::unordered_map<ObjectPtr, std::shared_ptr<const ObjectQuery>> compiled_;
  size_t sweep_at_ = kFewQueries;
};

}  // namespace

std::shared_ptr<SceneQueries> make_world_queries(const Parser& parser) {
  return std::make_shared<WorldQueries>(parser);
}

}  // namespace durer
