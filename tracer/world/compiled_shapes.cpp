#include "tracer/world/compiled_shapes.h"

#include <algorithm>

#include "tracer/intersect/mesh.h"

namespace durer {
namespace {

// Most shapes are quick to compile, and used once.
bool is_dear(const ShapeNode& node) {
  return std::holds_alternative<Rare<MeshNode>>(node) ||
         std::holds_alternative<HeightFieldNode>(node) || std::holds_alternative<BlobNode>(node) ||
         std::holds_alternative<Rare<IsosurfaceNode>>(node) ||
         std::holds_alternative<Rare<ParametricNode>>(node);
}

}  // namespace

PlacedShape CompiledShapes::shape(const std::shared_ptr<const ShapeNode>& node,
                                  const ShapeContext& context) {
  if (!is_dear(*node)) return compile_shape(*node, context);
  const auto found = known_.find(node);
  if (found != known_.end() && found->second.effective_version == context.effective_version) {
    return found->second.placed;
  }
  const long owners = node.use_count();
  PlacedShape placed;
  if (std::holds_alternative<Rare<MeshNode>>(*node)) {
    placed.shape = compile_mesh(node);
  } else {
    placed = compile_shape(*node, context);
  }
  keep(node, {context.effective_version, placed, {}, 0}, owners);
  return placed;
}

std::vector<PlacedGlyph> CompiledShapes::text(const std::shared_ptr<const ShapeNode>& node) {
  const auto found = known_.find(node);
  if (found != known_.end()) return found->second.glyphs;
  const long owners = node.use_count();
  std::vector<PlacedGlyph> glyphs = lay_out_text(std::get<Rare<TextNode>>(*node));
  keep(node, {0, {}, glyphs, 0}, owners);
  return glyphs;
}

// What nobody else has any more will not be asked for again.
void CompiledShapes::keep(const std::shared_ptr<const ShapeNode>& node, Known&& known,
                          long owners_before) {
  if (known_.size() >= sweep_at_) {
    std::erase_if(known_, [](const auto& entry) {
      return entry.first.use_count() == entry.second.owners;
    });
    sweep_at_ = std::max<size_t>(64, 2 * known_.size());
  }
  Known& kept = known_.insert_or_assign(node, std::move(known)).first->second;
  kept.owners = node.use_count() - owners_before;
}

}  // namespace durer
