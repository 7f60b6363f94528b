#include "tracer/scene/texture.h"

#include "tracer/scene/media.h"

namespace durer {

std::shared_ptr<const PigmentNode> transformed(const std::shared_ptr<const PigmentNode>& pigment,
                                               const Transform& transform, PlainColors plain) {
  if (!pigment) return pigment;
  if (plain == PlainColors::stay && pigment->pattern->kind == PatternKind::none) return pigment;
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

TexturePtr transformed(const TexturePtr& texture, const Transform& transform, PlainColors plain) {
  if (!texture) return texture;
  auto copy = std::make_shared<TextureNode>(*texture);
  if (texture->kind == TextureNode::Kind::plain) {
    copy->pigment = transformed(texture->pigment, transform, plain);
    copy->normal = transformed(texture->normal, transform);
  } else {
    append_transform(copy->choice.edit().pattern.warps, transform);
  }
  copy->below = transformed(texture->below, transform, plain);
  return copy;
}

std::shared_ptr<const InteriorNode> transformed(const std::shared_ptr<const InteriorNode>& interior,
                                                const Transform& transform) {
  if (!interior || interior->media.empty()) return interior;
  auto copy = std::make_shared<InteriorNode>(*interior);
  for (auto& media : copy->media) {
    auto moved = std::make_shared<MediaNode>(*media);
    for (auto& density : moved->densities) density = transformed(density, transform);
    media = std::move(moved);
  }
  return copy;
}

}  // namespace durer
