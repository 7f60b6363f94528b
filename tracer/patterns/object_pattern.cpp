// object, pigment_pattern, function: patterns that ask other rooms.
//
//   pigment { object { Shape color rgb 1, color rgb 0 } }      1 inside the object, else 0
//   pigment { pigment_pattern { marble } color_map { ... } }   grey of another pigment
//   pigment { function { sin(x) * y } color_map { ... } }      folded above 1
//
// Source: spec/textures.md 6.
#include <algorithm>
#include <cmath>

#include "tracer/functions/compiled_function.h"
#include "tracer/patterns/pattern_factories.h"
#include "tracer/scene/function.h"

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

class PigmentPattern : public BasePattern {
 public:
  explicit PigmentPattern(std::shared_ptr<const GreyField> pigment)
      : pigment_(std::move(pigment)) {}
  double base_value(const Vec3& p, const PatternContext& context) const override {
    return pigment_->grey(p, context);
  }

 private:
  std::shared_ptr<const GreyField> pigment_;
};

class FunctionPattern : public BasePattern {
 public:
  explicit FunctionPattern(std::shared_ptr<const ScalarField> function)
      : function_(std::move(function)) {}
  double base_value(const Vec3& p, const PatternContext&) const override {
    const double v = function_->value(p);
    return v > 1 ? std::fmod(v, 1.0) : v;
  }
  ValueRange base_range(const Bounds& box) const override {
    const ValueRange range = function_->range(box);
    return range.upper <= 1 ? range : ValueRange{std::min(range.lower, 0.0), 1};
  }

 private:
  std::shared_ptr<const ScalarField> function_;
};

}  // namespace

std::unique_ptr<const BasePattern> make_object(const PatternNode& node,
                                               const PatternSettings& settings) {
  return std::make_unique<ObjectPattern>(settings.services->inside_test(node.object));
}

std::unique_ptr<const BasePattern> make_pigment_pattern(const PatternNode& node,
                                                        const PatternSettings& settings) {
  return std::make_unique<PigmentPattern>(settings.services->grey_field(node.pigment));
}

std::unique_ptr<const BasePattern> make_function(const PatternNode& node,
                                                 const PatternSettings&) {
  return std::make_unique<FunctionPattern>(node.function->compiled);
}

}  // namespace durer
