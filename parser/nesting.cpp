#include "parser/nesting.h"

#include <algorithm>

#include "tracer/scene/function.h"
#include "tracer/scene/light.h"

namespace durer {

int Nesting::find(const void* node) const {
  const auto found = known_.find(node);
  return found != known_.end() && !found->second.node.expired() ? found->second.levels : -1;
}

void Nesting::remember(std::shared_ptr<const void> node, int levels) {
  const void* const address = node.get();
  known_[address] = {std::move(node), levels};
  if (known_.size() < sweep_at_) return;
  std::erase_if(known_, [](const auto& entry) { return entry.second.node.expired(); });
  sweep_at_ = std::max<size_t>(1024, 2 * known_.size());
}

template <typename Map>
int Nesting::levels_of_map(const std::shared_ptr<const Map>& map) {
  int most = 0;
  if (map) {
    for (const auto& entry : map->entries) most = std::max(most, 1 + levels(entry.item));
  }
  return most;
}

int Nesting::levels(const PatternNode& pattern) {
  int most = 0;
  if (pattern.object) most = std::max(most, 1 + pattern.object->csg_depth);
  if (pattern.pigment) most = std::max(most, 1 + levels(pattern.pigment));
  if (pattern.function) most = std::max(most, 1 + levels(pattern.function->compiled));
  return most;
}

// Pigments and normals: a pattern, perhaps a map.
template <typename Node, typename Map>
int Nesting::levels_of_patterned(const std::shared_ptr<const Node>& node,
                                 const std::shared_ptr<const Map>& map) {
  const PatternNode& pattern = *node->pattern;
  if (!map && !pattern.object && !pattern.pigment && !pattern.function) return 0;
  int most = find(node.get());
  if (most >= 0) return most;
  most = std::max(levels_of_map(map), levels(pattern));
  remember(node, most);
  return most;
}

int Nesting::levels(const std::shared_ptr<const PigmentNode>& pigment) {
  if (!pigment) return 0;
  return levels_of_patterned(pigment, pigment->maps->pigment_map);
}

int Nesting::levels(const std::shared_ptr<const NormalNode>& normal) {
  if (!normal) return 0;
  return levels_of_patterned(normal, normal->normal_map);
}

int Nesting::levels(const TexturePtr& texture) {
  if (!texture) return 0;
  if (texture->kind == TextureNode::Kind::plain && !texture->below) {
    return std::max(levels(texture->pigment), levels(texture->normal));
  }
  int most = find(texture.get());
  if (most >= 0) return most;
  const TextureChoice& choice = *texture->choice;
  most = std::max({levels(texture->pigment), levels(texture->normal), levels(choice.pattern),
                   levels_of_map(choice.map)});
  for (const TexturePtr& material : choice.materials) {
    most = std::max(most, 1 + levels(material));
  }
  if (texture->below) most = std::max(most, 1 + levels(texture->below));
  remember(texture, most);
  return most;
}

int Nesting::levels(const std::shared_ptr<const CompiledFunction>& function) const {
  return std::max(0, find(function.get()));
}

void Nesting::note(const std::shared_ptr<const CompiledFunction>& function, int levels) {
  if (levels > 0) remember(function, levels);
}

int Nesting::levels_of_shape(const ShapeNode& shape) {
  int most = 0;
  if (const auto* csg = std::get_if<CsgNode>(&shape)) {
    for (const ObjectPtr& child : csg->children) most = std::max(most, 1 + child->csg_depth);
  } else if (const auto* light = std::get_if<std::shared_ptr<const LightNode>>(&shape)) {
    for (const ObjectPtr& object : {(*light)->looks_like, (*light)->projected_through}) {
      if (object) most = std::max(most, 1 + object->csg_depth);
    }
  } else if (const auto* blob = std::get_if<BlobNode>(&shape)) {
    for (const BlobComponent& component : blob->components) {
      if (component.texture) most = std::max(most, 1 + levels(component.texture));
    }
  } else if (const auto* isosurface = std::get_if<Rare<IsosurfaceNode>>(&shape)) {
    if (const auto& function = isosurface->get().function) {
      most = std::max(most, 1 + levels(function->compiled));
    }
  } else if (const auto* parametric = std::get_if<Rare<ParametricNode>>(&shape)) {
    for (const auto& function : parametric->get().function) {
      if (function) most = std::max(most, 1 + levels(function->compiled));
    }
  } else if (const auto* mesh = std::get_if<Rare<MeshNode>>(&shape)) {
    for (const TexturePtr& texture : mesh->get().textures) {
      most = std::max(most, 1 + levels(texture));
    }
  }
  return most;
}

int Nesting::levels(const ObjectNode& object) {
  int most = object.base ? object.base->csg_depth : 0;
  if (object.shape) most = std::max(most, levels_of_shape(*object.shape));
  const auto count_all = [&](const std::vector<ObjectPtr>& objects) {
    for (const ObjectPtr& other : objects) most = std::max(most, 1 + other->csg_depth);
  };
  for (const Modifier& modifier : object.modifiers) {
    if (const auto* texture = std::get_if<SetTexture>(&modifier)) {
      most = std::max(most, levels(texture->texture));
    } else if (const auto* inner = std::get_if<SetInteriorTexture>(&modifier)) {
      most = std::max(most, levels(inner->texture));
    } else if (const auto* bounds = std::get_if<AddBounds>(&modifier)) {
      count_all(*bounds->objects);
    } else if (const auto* clips = std::get_if<AddClips>(&modifier)) {
      count_all(*clips->objects);
    }
  }
  return most;
}

}  // namespace durer
