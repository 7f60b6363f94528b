#include "tracer/world/texture_table.h"

namespace durer {
namespace {

bool looks_the_same_everywhere(const TextureNode& texture) {
  for (const TextureNode* layer = &texture; layer; layer = layer->below.get()) {
    if (layer->kind != TextureNode::Kind::plain) return false;
    if (layer->pigment && layer->pigment->pattern->kind != PatternKind::none) return false;
    if (layer->normal && layer->normal->pattern->kind != PatternKind::none) return false;
  }
  return true;
}

bool needs_uv(const PatternNode& pattern);

bool needs_uv(const PigmentNode* pigment) {
  if (!pigment) return false;
  if (needs_uv(pigment->pattern)) return true;
  if (pigment->maps->pigment_map) {
    for (const auto& entry : pigment->maps->pigment_map->entries) {
      if (needs_uv(entry.item.get())) return true;
    }
  }
  return false;
}

bool needs_uv(const NormalNode* normal) {
  if (!normal) return false;
  if (needs_uv(normal->pattern)) return true;
  if (normal->normal_map) {
    for (const auto& entry : normal->normal_map->entries) {
      if (needs_uv(entry.item.get())) return true;
    }
  }
  return false;
}

bool needs_uv(const PatternNode& pattern) {
  return pattern.kind == PatternKind::uv_mapping || needs_uv(pattern.pigment.get());
}

bool needs_uv(const TextureNode& texture) {
  for (const TextureNode* layer = &texture; layer; layer = layer->below.get()) {
    if (needs_uv(layer->choice->pattern) || needs_uv(layer->pigment.get()) ||
        needs_uv(layer->normal.get())) {
      return true;
    }
    const TextureChoice& choice = *layer->choice;
    if (choice.map) {
      for (const auto& entry : choice.map->entries) {
        if (entry.item && needs_uv(*entry.item)) return true;
      }
    }
    for (const TexturePtr& material : choice.materials) {
      if (material && needs_uv(*material)) return true;
    }
  }
  return false;
}

}  // namespace

uint32_t TextureTable::add(const TextureNode& texture) {
  pages_.before_push(textures_);
  textures_.push_back(compile_texture(texture, settings_));
  uses_uv_.push_back(needs_uv(texture));
  return static_cast<uint32_t>(textures_.size() - 1);
}

uint32_t TextureTable::index_of(const MovedTexture& texture) {
  const TextureNode* node = texture.texture.get();
  if (texture.moves.empty() || looks_the_same_everywhere(*node)) {
    // Nobody else has it, so nobody will ask for it again.
    if (texture.texture.use_count() == 1) return add(*node);
    const auto [place, is_new] = unmoved_.try_emplace(node, 0);
    if (is_new) {
      kept_.push_back(texture.texture);
      place->second = add(*node);
    }
    return place->second;
  }
  Matrix whole = texture.moves.front().forward;
  for (size_t i = 1; i < texture.moves.size(); ++i) whole = whole * texture.moves[i].forward;
  Placement placement{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) placement[3 * i + j] = whole.row[i][j];
  }
  const auto [place, is_new] = moved_.try_emplace({node, placement}, 0);
  if (is_new) {
    kept_.push_back(texture.texture);
    TexturePtr moved = texture.texture;
    for (const Transform& move : texture.moves) moved = transformed(moved, move);
    place->second = add(*moved);
  }
  return place->second;
}

}  // namespace durer
