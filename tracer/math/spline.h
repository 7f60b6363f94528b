// spline{}: interpolation of 2..5 numbers over a parameter (spec/language.md 21).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace durer {

enum class SplineInterpolation : uint8_t { linear, quadratic, cubic, natural };

struct SplineKnot {
  double parameter = 0;
  std::array<double, 5> value{};
};

class Spline {
 public:
  SplineInterpolation kind = SplineInterpolation::linear;

  // Adds a knot that was written with 1..5 numbers, with the language's rules: knots are kept sorted,
  // a repeated parameter replaces the earlier value unless it is the largest of several. Numbers
  // behind `terms` count if another knot is longer.
  void add(double parameter, const std::array<double, 5>& value, int terms);

  bool empty() const { return knots_.empty(); }
  // Numbers in a value: 2..5.
  int terms() const { return terms_; }
  const std::vector<SplineKnot>& knots() const { return knots_; }

  // After the last knot: solves the natural spline for its second derivatives.
  void complete();

  // Writes five numbers, also those behind terms(). At least one knot, and complete.
  void evaluate(double t, double* result) const { evaluate(t, kind, result); }
  void evaluate(double t, SplineInterpolation as, double* result) const;

 private:
  std::vector<SplineKnot> knots_;  // by parameter
  std::vector<std::array<double, 5>> second_derivatives_;  // of the natural spline
  int terms_ = 2;
};

}  // namespace durer
