// How deep textures, patterns, functions and objects stand in each other. Those are walked by
// recursion when they are evaluated and freed, and names let a loop nest them without any nested
// text; so the parser counts the levels.
#pragma once

#include <memory>
#include <unordered_map>

#include "tracer/scene/object.h"

namespace durer {

class CompiledFunction;

// 0: nothing of these kinds is in the node. Levels are worked out once for each node that holds
// others, and remembered as long as it lives.
class Nesting {
 public:
  int levels(const std::shared_ptr<const PigmentNode>& pigment);
  int levels(const std::shared_ptr<const NormalNode>& normal);
  int levels(const TexturePtr& texture);
  int levels(const PatternNode& pattern);
  int levels(const std::shared_ptr<const CompiledFunction>& function) const;
  // Of an object under construction: its shape and modifiers, the members' levels being known.
  int levels(const ObjectNode& object);
  void note(const std::shared_ptr<const CompiledFunction>& function, int levels);

 private:
  struct Known {
    std::weak_ptr<const void> node;
    int levels = 0;
  };
  int find(const void* node) const;  // -1: not known
  void remember(std::shared_ptr<const void> node, int levels);
  template <typename Map>
  int levels_of_map(const std::shared_ptr<const Map>& map);
  template <typename Node, typename Map>
  int levels_of_patterned(const std::shared_ptr<const Node>& node,
                          const std::shared_ptr<const Map>& map);
  int levels_of_shape(const ShapeNode& shape);

  std::unordered_map<const void*, Known> known_;
  size_t sweep_at_ = 1024;  // forgotten nodes are swept out when there are so many
};

}  // namespace durer
