// Statistics: how often rays were tested against each kind of shape, and how often they met it.
#pragma once

#include <array>
#include <cstdint>

#include "tracer/scene/shapes.h"

namespace durer {

struct ShapeTests {
  uint64_t by_outcome[2] = {};  // missed, met

  uint64_t tests() const { return by_outcome[0] + by_outcome[1]; }
  uint64_t hits() const { return by_outcome[1]; }
};
// By ShapeNode::index(). A mesh counts as one shape.
using ShapeTestCounts = std::array<ShapeTests, std::variant_size_v<ShapeNode>>;

}  // namespace durer
