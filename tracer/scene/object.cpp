#include "tracer/scene/object.h"

namespace durer {

const ShapeNode& shape_of(const ObjectNode& object) {
  const ObjectNode* node = &object;
  while (!node->shape) node = node->base.get();
  return *node->shape;
}

ResolvedTextures resolve_textures(const ObjectNode& object) {
  ResolvedTextures state;
  if (object.base) state = resolve_textures(*object.base);
  for (const Modifier& modifier : object.modifiers) {
    if (const auto* transform = std::get_if<Transform>(&modifier)) {
      // A uv-mapped texture stays with the surface.
      if (state.uv_mapping) continue;
      state.texture = transformed(state.texture, *transform);
      state.interior_texture = transformed(state.interior_texture, *transform);
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
  return state;
}

}  // namespace durer
