// Shapes that are dear to compile, each compiled once for all objects that have it.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "tracer/shapes/shape.h"
#include "tracer/shapes/text.h"

namespace durer {

class CompiledShapes {
 public:
  // Of a shape that stands for itself (see compile_shape()), or a mesh.
  PlacedShape shape(const std::shared_ptr<const ShapeNode>& node, const ShapeContext& context);
  // The characters of a text.
  std::vector<PlacedGlyph> text(const std::shared_ptr<const ShapeNode>& node);

 private:
  struct Known {
    int effective_version = 0;
    PlacedShape placed;
    std::vector<PlacedGlyph> glyphs;
    long owners = 0;  // of the node, that are ours
  };
  void keep(const std::shared_ptr<const ShapeNode>& node, Known&& known, long owners_before);

  std::unordered_map<std::shared_ptr<const ShapeNode>, Known> known_;
  size_t sweep_at_ = 64;
};

}  // namespace durer
