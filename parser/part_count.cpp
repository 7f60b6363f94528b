#include "parser/part_count.h"

#include "tracer/scene/shapes.h"

namespace durer {

double PartCount::of(const ObjectNode& object) {
  // Copies of copies may form long chains.
  std::vector<const ObjectNode*> chain;
  const ObjectNode* node = &object;
  for (;; node = node->base.get()) {
    if (known_.contains(node)) break;
    chain.push_back(node);
    if (!node->base) break;
  }
  double count = 0;
  if (chain.empty() || chain.back() != node) {
    count = known_.at(node);
  }
  while (!chain.empty()) {
    const ObjectNode& next = *chain.back();
    chain.pop_back();
    const auto add = [&](const std::vector<ObjectPtr>& others) {
      for (const ObjectPtr& other : others) count += of(*other);
    };
    if (!next.base) {
      const auto* csg = next.shape ? std::get_if<CsgNode>(next.shape.get()) : nullptr;
      if (csg) add(csg->children);
      else count = 1;
    }
    for (const Modifier& modifier : next.modifiers) {
      if (const auto* bounds = std::get_if<AddBounds>(&modifier)) add(*bounds->objects);
      if (const auto* clips = std::get_if<AddClips>(&modifier)) add(*clips->objects);
    }
    if (count > 1) known_[&next] = count;  // the others are as quickly counted again
  }
  return count;
}

}  // namespace durer
