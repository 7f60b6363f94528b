#include "tracer/scene/pattern.h"

namespace durer {

void append_transform(std::vector<Warp>& chain, const Transform& transform) {
  if (!chain.empty()) {
    if (auto* last = std::get_if<Transform>(&chain.back())) {
      *last = last->then(transform);
      return;
    }
  }
  chain.emplace_back(transform);
}

}  // namespace durer
