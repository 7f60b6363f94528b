// Builds the nodes of a Bvh.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/intersect/bvh.h"

namespace durer {

// An item's box on its way into the leaves: two aligned rows of four.
struct alignas(16) BvhBuildItem {
  float low[3];
  uint32_t item;
  float high[3];
  uint32_t unused = 0;
};

// Writes the nodes, root first, and the item numbers in the order of the leaves. Reorders `boxes`.
void build_bvh_nodes(std::vector<BvhBuildItem>& boxes, std::vector<BvhNode>& nodes,
                     std::vector<uint32_t>& items);

}  // namespace durer
