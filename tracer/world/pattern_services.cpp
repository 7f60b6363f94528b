#include "tracer/world/pattern_services.h"

#include "tracer/patterns/pattern_grey.h"
#include "tracer/world/world.h"

namespace durer {
namespace {

class ObjectInside final : public InsideTest {
 public:
  explicit ObjectInside(std::shared_ptr<const ObjectQuery> object) : object_(std::move(object)) {}
  bool inside(const Vec3& p) const override { return object_->inside(p); }

 private:
  std::shared_ptr<const ObjectQuery> object_;
};

class PigmentGrey final : public GreyField {
 public:
  explicit PigmentGrey(std::shared_ptr<const CompiledPigment> pigment)
      : pigment_(std::move(pigment)) {}
  double grey(const Vec3& p, const PatternContext& context) const override {
    ColorRGBFT color;
    // Beside an image that is there once.
    if (!pigment_->evaluate(p, context, color)) return 0;
    return static_cast<double>(pattern_grey(color));
  }

 private:
  std::shared_ptr<const CompiledPigment> pigment_;
};

}  // namespace

std::shared_ptr<const InsideTest> WorldPatternServices::inside_test(
    const std::shared_ptr<const ObjectNode>& object) const {
  return std::make_shared<ObjectInside>(ObjectQuery::build(object, settings_.effective_version));
}

std::shared_ptr<const GreyField> WorldPatternServices::grey_field(
    const std::shared_ptr<const PigmentNode>& pigment) const {
  return std::make_shared<PigmentGrey>(compile_pigment(*pigment, settings_));
}

}  // namespace durer
