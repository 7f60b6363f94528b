// Which objects cast shadows, and in which bounds: opaque ones stop light, others are asked for what
// they let through (docs/decisions/0062-shadows-of-bound-unions.md).
#pragma once

#include "tracer/world/world_builder.h"

namespace durer {

// Whether nothing of a node lets light through: by its textures.
bool is_opaque_node(const WorldData& data, uint32_t node);

// Finite objects that only their box cuts cast their shadows whole.
inline bool casts_whole_shadow(const TopLevelObject& object, const GeometryNode& node) {
  return object.is_cut_off && !node.bounds.count && node.surface_is_bounded;
}

// Sorts the casters of shadows into opaque and clear ones, once textures are known; the members of
// copies answer for themselves, so their sets come first.
void sort_shadow_casters(const WorldData& data, ObjectSet& set);

}  // namespace durer
