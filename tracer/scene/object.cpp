#include "tracer/scene/object.h"

namespace durer {

ObjectNode::~ObjectNode() {
  while (base && base.use_count() == 1) {
    const auto dying = std::const_pointer_cast<ObjectNode>(base);
    base = std::move(dying->base);
  }
}

const ShapeNode& shape_of(const ObjectNode& object) {
  const ObjectNode* node = &object;
  while (!node->shape) node = node->base.get();
  return *node->shape;
}

namespace {

void apply_modifiers(const ObjectNode& node, PlainColors plain, ResolvedTextures& state) {
  for (const Modifier& modifier : node.modifiers) {
    if (const auto* transform = std::get_if<Rare<Transform>>(&modifier)) {
      state.interior = transformed(state.interior, *transform);
      // A uv-mapped texture stays with the surface.
      if (state.uv_mapping) continue;
      state.texture = transformed(state.texture, *transform, plain);
      state.interior_texture = transformed(state.interior_texture, *transform, plain);
    } else if (const auto* texture = std::get_if<SetTexture>(&modifier)) {
      state.texture = texture->texture;
    } else if (const auto* inner = std::get_if<SetInteriorTexture>(&modifier)) {
      state.interior_texture = inner->texture;
    } else if (const auto* interior = std::get_if<SetInterior>(&modifier)) {
      state.interior = interior->interior;
    } else if (const auto* flag = std::get_if<SetFlag>(&modifier)) {
      if (flag->flag == ObjectFlag::uv_mapping) state.uv_mapping = flag->value;
    }
  }
}

}  // namespace

ResolvedTextures resolve_textures(const ObjectNode& object, PlainColors plain) {
  if (!object.base) {
    ResolvedTextures state;
    apply_modifiers(object, plain, state);
    return state;
  }
  // From the shape's own statement to the last copy.
  std::vector<const ObjectNode*> chain;
  for (const ObjectNode* node = &object; node; node = node->base.get()) chain.push_back(node);
  ResolvedTextures state;
  while (!chain.empty()) {
    apply_modifiers(*chain.back(), plain, state);
    chain.pop_back();
  }
  return state;
}

}  // namespace durer
