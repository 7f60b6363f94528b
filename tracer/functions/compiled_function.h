// A function{} ready to be called: from the language, from other functions, from patterns, from
// isosurfaces (spec/functions.md).
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>

#include "tracer/field/field_settings.h"
#include "tracer/field/scalar_field.h"
#include "tracer/math/transform.h"

namespace durer {

class ColorField;
class Spline;

// Calls itself deeper than 1024 levels.
class FunctionRecursionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class FunctionKind : uint8_t { expression, internal, pattern, pigment, transform, spline };

// Immutable, shared by all threads; evaluation allocates nothing. As a ScalarField it is its first
// result at parameters (x, y, z); parameters beyond the third are 0, missing ones are not passed.
class CompiledFunction : public ScalarField {
 public:
  FunctionKind kind() const { return kind_; }
  int parameter_count() const { return parameter_count_; }
  // Numbers in a result: 1 for expressions, internal and pattern functions, 5 (red green blue filter
  // transmit) for pigments, 3 for transforms, 2..5 for splines.
  int result_width() const { return result_width_; }
  bool is_vector() const { return result_width_ > 1; }

  // arguments: parameter_count() numbers; result: room for result_width() numbers. They may overlap.
  virtual void evaluate(const double* arguments, double* result) const = 0;
  // The first number of the result.
  virtual double scalar(const double* arguments) const = 0;

  double value(const Vec3& p) const override;

 protected:
  CompiledFunction(FunctionKind kind, int parameter_count, int result_width)
      : parameter_count_(parameter_count), result_width_(result_width), kind_(kind) {}

 private:
  int parameter_count_;
  int result_width_;
  FunctionKind kind_;
};

using FunctionHandle = std::shared_ptr<const CompiledFunction>;

// `function { internal(number) }` (spec/functions.md 4); null if there is no such number. Each call
// is an identifier of its own: internal(59) keeps the weights of its first use (4.5).
FunctionHandle make_internal_function(int number, std::shared_ptr<const FieldSettings> settings);
// `function { pattern { } }`: the pattern's value after its wave.
FunctionHandle make_pattern_function(std::shared_ptr<const ScalarField> pattern);
// `function { pigment { } }`
FunctionHandle make_pigment_function(std::shared_ptr<const ColorField> pigment);
// `function { transform { } }`
FunctionHandle make_transform_function(const Transform& transform);
// `function { spline { } }`
FunctionHandle make_spline_function(std::shared_ptr<const Spline> spline);

}  // namespace durer
