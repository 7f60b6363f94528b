// Ranges of a parametric's coordinates over rectangles of its parameters (spec/functions.md 8.3).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tracer/functions/compiled_function.h"

namespace durer {

struct CoordinateRange {
  double low, high;
};

struct ParameterRectangle {
  double u0, u1, v0, v1;

  // The longer side is halved, u of two equal ones.
  bool splits_u() const { return u1 - u0 >= v1 - v0; }
  double middle() const { return splits_u() ? 0.5 * (u0 + u1) : 0.5 * (v0 + v1); }
};

// Values at (u0,v0) (u0,v1) (u1,v0) (u1,v1).
using Corners = std::array<double, 4>;

// One of the three functions of a parametric.
class ParametricCoordinate {
 public:
  ParametricCoordinate() = default;
  ParametricCoordinate(const CompiledFunction* function, double accuracy, double max_gradient)
      : function_(function), accuracy_(accuracy), max_gradient_(max_gradient) {}

  double operator()(double u, double v) const { return function_->value(Vec3(u, v, 0)); }
  Corners corners(const ParameterRectangle& r) const;
  // Those of both halves, which share the two in the middle.
  std::pair<Corners, Corners> halves(const ParameterRectangle& r, const Corners& whole) const;
  // As far as the corners and max_gradient tell.
  CoordinateRange estimate(const ParameterRectangle& r, const Corners& f) const;

 private:
  const CompiledFunction* function_ = nullptr;
  double accuracy_ = 0;
  double max_gradient_ = 0;
};

// `precompute DEPTH`: at the last of its levels a range is the estimate, above it the union of those of
// both halves, whatever the estimate would have been. A max_gradient that is too small for large
// rectangles therefore loses less. Rectangles have numbers: the root 1, the halves of n 2n and 2n+1.
class PrecomputedBounds {
 public:
  PrecomputedBounds() = default;
  // Levels below least_side, which no ray asks for, are looked at and not kept.
  PrecomputedBounds(const ParametricCoordinate& coordinate, const ParameterRectangle& root,
                    int depth, double least_side);

  bool empty() const { return bounds_.empty(); }
  // Numbers below it are known.
  uint32_t count() const { return static_cast<uint32_t>(bounds_.size()); }
  const CoordinateRange& operator[](uint32_t number) const { return bounds_[number]; }

 private:
  CoordinateRange compute(const ParametricCoordinate& coordinate, const ParameterRectangle& r,
                   const Corners& corners, uint32_t number, int depth);

  std::vector<CoordinateRange> bounds_;
};

}  // namespace durer
