// The warps of textures that are chosen by place without a pattern value: images, averages.
#pragma once

#include <vector>

#include "tracer/scene/pattern.h"

namespace durer {

// The chain of a pattern with its turbulence slot, which comes last, whatever its place in the text
// (spec/textures.md 3.1); apply_warps goes from the last item to the first.
inline std::vector<Warp> chain_with_slot(const PatternNode& node) {
  std::vector<Warp> chain = node.warps;
  if (node.has_turbulence && node.turbulence.strength != Vec3(0)) {
    chain.insert(chain.begin(), node.turbulence);
  }
  return chain;
}

}  // namespace durer
