#include "tracer/world/shadow_casters.h"

namespace durer {
namespace {

// A union that is bound somewhere: its opaque members cast their shadows whatever bounds it.
bool is_loose_union(const Geometry& geometry, uint32_t index) {
  const GeometryNode& node = geometry.nodes[index];
  if (node.kind != NodeKind::union_ || node.clips.count) return false;
  if (node.bounds.count) return true;
  for (uint32_t i = 0; i < node.children.count; ++i) {
    if (is_loose_union(geometry, geometry.lists[node.children.first + i])) return true;
  }
  return false;
}

// What is a caster of shadows in other bounds than as an object.
bool is_loose(const WorldData& data, const TopLevelObject& top) {
  return is_loose_union(data.geometry, top.node) ||
         (casts_whole_shadow(top, data.geometry.nodes[top.node]) && is_opaque_node(data, top.node));
}

void add_opaque_members(const WorldData& data, uint32_t object, uint32_t index,
                        std::vector<LooseMember>& members) {
  if (is_loose_union(data.geometry, index)) {
    const GeometryNode& node = data.geometry.nodes[index];
    for (uint32_t i = 0; i < node.children.count; ++i) {
      add_opaque_members(data, object, data.geometry.lists[node.children.first + i], members);
    }
  } else if (is_opaque_node(data, index)) {
    members.push_back({object, index});
  }
}

}  // namespace

bool is_opaque_node(const WorldData& data, uint32_t index) {
  const GeometryNode& node = data.geometry.nodes[index];
  if (node.kind != NodeKind::shape) {
    for (uint32_t i = 0; i < node.children.count; ++i) {
      if (!is_opaque_node(data, data.geometry.lists[node.children.first + i])) return false;
    }
    return true;
  }
  const WorldObject& object = data.objects[node.object];
  const NodeAppearance& appearance = data.appearance[index];
  const auto lets_light_through = [&](uint32_t texture) {
    return texture != kNoTexture && !data.textures[texture].is_opaque;
  };
  if (lets_light_through(object.texture) || lets_light_through(object.interior_texture)) {
    return false;
  }
  // No texture at all, and textures of parts, are left to shading.
  if (object.texture == kNoTexture && appearance.own_textures < 0) return false;
  if (appearance.own_textures >= 0) {
    const size_t count = node.shape->own_textures()->size();
    for (size_t i = 0; i < count; ++i) {
      if (lets_light_through(data.own_texture_ids[appearance.own_textures + i])) return false;
    }
  }
  return true;
}

void sort_shadow_casters(const WorldData& data, ObjectSet& set) {
  std::vector<LooseMember> members;
  for (uint32_t i = 0; i < set.objects.size(); ++i) {
    const TopLevelObject& top = set.objects[i];
    if (top.instance >= 0 || top.hidden & kShadowRay || !is_loose(data, top)) continue;
    add_opaque_members(data, i, top.node, members);
  }
  const auto casts = [&](uint32_t i, bool opaque) {
    const TopLevelObject& top = set.objects[i];
    if (top.hidden & kShadowRay) return false;
    if (top.instance >= 0) {
      const ObjectSet& inner = data.groups[data.instances[top.instance].group]->set;
      return !(opaque ? inner.opaque_casters() : inner.clear_casters()).is_empty();
    }
    if (is_opaque_node(data, top.node) != opaque) return false;
    // Loose opaque ones are there by their members.
    return members.empty() || !opaque || !is_loose(data, top);
  };
  const auto list = [&](bool opaque, std::unique_ptr<SearchList>& casters) {
    casters.reset();
    const auto wanted = [&](uint32_t i) { return casts(i, opaque); };
    bool all = true;
    for (uint32_t i = 0; i < set.objects.size() && all; ++i) all = wanted(i);
    if (all) return;
    casters = std::make_unique<SearchList>();
    fill_search_list(data.geometry, set, wanted, opaque ? members : std::vector<LooseMember>{},
                     *casters);
  };
  list(true, set.opaque);
  list(false, set.clear);
}

}  // namespace durer
