#include "tracer/functions/compiled_function.h"

#include "tracer/math/spline.h"
#include "tracer/patterns/color_field.h"

namespace durer {

double CompiledFunction::value(const Vec3& p) const {
  // At most 56 parameters can be declared (spec/functions.md 1.1).
  double arguments[64] = {p.x, p.y, p.z};
  return scalar(arguments);
}

namespace {

class PatternFunction final : public CompiledFunction {
 public:
  explicit PatternFunction(std::shared_ptr<const ScalarField> pattern)
      : CompiledFunction(FunctionKind::pattern, 3, 1), pattern_(std::move(pattern)) {}
  void evaluate(const double* a, double* result) const override { *result = scalar(a); }
  double scalar(const double* a) const override { return pattern_->value({a[0], a[1], a[2]}); }
  ValueRange range(const Bounds& box) const override { return pattern_->range(box); }

 private:
  std::shared_ptr<const ScalarField> pattern_;
};

class PigmentFunction final : public CompiledFunction {
 public:
  explicit PigmentFunction(std::shared_ptr<const ColorField> pigment)
      : CompiledFunction(FunctionKind::pigment, 3, 5), pigment_(std::move(pigment)) {}
  void evaluate(const double* a, double* result) const override {
    ColorRGBFT color;
    pigment_->color({a[0], a[1], a[2]}, nullptr, color);
    result[0] = color.red;
    result[1] = color.green;
    result[2] = color.blue;
    result[3] = color.filter;
    result[4] = color.transmit;
  }
  double scalar(const double* a) const override {
    double result[5];
    evaluate(a, result);
    return result[0];
  }

 private:
  std::shared_ptr<const ColorField> pigment_;
};

class TransformFunction final : public CompiledFunction {
 public:
  explicit TransformFunction(const Transform& transform)
      : CompiledFunction(FunctionKind::transform, 3, 3), transform_(transform) {}
  void evaluate(const double* a, double* result) const override {
    const Vec3 p = transform_.point({a[0], a[1], a[2]});
    result[0] = p.x;
    result[1] = p.y;
    result[2] = p.z;
  }
  double scalar(const double* a) const override {
    return transform_.point({a[0], a[1], a[2]}).x;
  }

 private:
  Transform transform_;
};

class SplineFunction final : public CompiledFunction {
 public:
  explicit SplineFunction(std::shared_ptr<const Spline> spline)
      : CompiledFunction(FunctionKind::spline, 1, spline->terms()), spline_(std::move(spline)) {}
  void evaluate(const double* a, double* result) const override {
    spline_->evaluate(a[0], result);
  }
  double scalar(const double* a) const override {
    double result[5];
    spline_->evaluate(a[0], result);
    return result[0];
  }

 private:
  std::shared_ptr<const Spline> spline_;
};

}  // namespace

FunctionHandle make_pattern_function(std::shared_ptr<const ScalarField> pattern) {
  return std::make_shared<PatternFunction>(std::move(pattern));
}
FunctionHandle make_pigment_function(std::shared_ptr<const ColorField> pigment) {
  return std::make_shared<PigmentFunction>(std::move(pigment));
}
FunctionHandle make_transform_function(const Transform& transform) {
  return std::make_shared<TransformFunction>(transform);
}
FunctionHandle make_spline_function(std::shared_ptr<const Spline> spline) {
  return std::make_shared<SplineFunction>(std::move(spline));
}

}  // namespace durer
