// Where on the lens the rays of focal blur pass (spec/shading.md 4.1, 4.2).
#pragma once

#include <functional>
#include <vector>

#include "tracer/math/vector.h"

namespace durer {

struct LensPattern {
  // In the square [-1/2, 1/2]^2 around the lens's axis, in the order of their use.
  std::vector<Vec2> points;
  // Every sample is moved by up to this much from its point, in each axis to both sides.
  double jitter = 0;
  // How many samples are taken before the spread is looked at again; later batches have 4.
  std::vector<int> first_batches;
};

// `count` points over a round lens: a hexagonal grid, and a Halton sequence where it has gaps.
LensPattern round_lens(int count);
// As densely as `brightness` says, which is asked for points of the unit square (bokeh).
LensPattern shaped_lens(int count, const std::function<double(const Vec2&)>& brightness);

}  // namespace durer
