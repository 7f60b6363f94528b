// Which objects cast shadows, and in which bounds: opaque ones stop light, others are asked for what
// they let through (docs/decisions/0062-shadows-of-bound-unions.md).
#pragma once

#include "tracer/world/world_builder.h"

namespace durer {

// Whether nothing of a node lets light through: by its textures.
bool is_opaque_node(const WorldData& data, uint32_t node);

// Shapes that only their box or the box of what clips them cuts cast their shadows whole; solids of
// several, such as intersections with discs, do not (measured on povray 3.7).
inline bool casts_whole_shadow(const TopLevelObject& object, const GeometryNode& node) {
  return object.is_cut_off && node.kind == NodeKind::shape && !node.bounds.count &&
         (node.surface_is_bounded || node.clips.count);
}

// Sorts the casters of shadows into opaque and clear ones, once textures are known; the members of
// copies answer for themselves, so their sets come first.
void sort_shadow_casters(const WorldData& data, ObjectSet& set);

}  // namespace durer
