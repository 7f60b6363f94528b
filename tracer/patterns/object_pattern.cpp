// object, pigment_pattern: patterns that ask other rooms.
//
//   pigment { object { Shape color rgb 1, color rgb 0 } }   1 inside the object, else 0
//
// Source: spec/textures.md 6.
#include "tracer/patterns/pattern_factories.h"
#include "tracer/scene/not_supported.h"

namespace durer {
namespace {

class ObjectPattern : public BasePattern {
 public:
  explicit ObjectPattern(std::shared_ptr<const InsideTest> test) : test_(std::move(test)) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    return test_->inside(p) ? 1 : 0;
  }
  ValueRange base_range(const Bounds&) const override { return {0, 1}; }

 private:
  std::shared_ptr<const InsideTest> test_;
};

}  // namespace

std::unique_ptr<const BasePattern> make_object(const PatternNode& node,
                                               const PatternSettings& settings) {
  if (!settings.services) throw NotSupported("the pattern 'object' here", node.position);
  return std::make_unique<ObjectPattern>(settings.services->inside_test(node.object));
}

}  // namespace durer
