#include "tracer/scene/texture.h"

namespace durer {

std::shared_ptr<const PigmentNode> transformed(const std::shared_ptr<const PigmentNode>& pigment,
                                               const Transform& transform) {
  // A solid colour looks the same everywhere.
  if (!pigment || pigment->pattern->kind == PatternKind::none) return pigment;
  auto copy = std::make_shared<PigmentNode>(*pigment);
  append_transform(copy->pattern.edit().warps, transform);
  return copy;
}

std::shared_ptr<const NormalNode> transformed(const std::shared_ptr<const NormalNode>& normal,
                                              const Transform& transform) {
  if (!normal || normal->pattern->kind == PatternKind::none) return normal;
  auto copy = std::make_shared<NormalNode>(*normal);
  append_transform(copy->pattern.edit().warps, transform);
  return copy;
}

TexturePtr transformed(const TexturePtr& texture, const Transform& transform) {
  if (!texture) return texture;
  auto copy = std::make_shared<TextureNode>(*texture);
  if (texture->kind == TextureNode::Kind::plain) {
    copy->pigment = transformed(texture->pigment, transform);
    copy->normal = transformed(texture->normal, transform);
  } else {
    append_transform(copy->choice.edit().pattern.warps, transform);
  }
  copy->below = transformed(texture->below, transform);
  return copy;
}

}  // namespace durer
