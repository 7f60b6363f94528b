// Solids that POV-Ray remembers as the last thing that stopped a light, though parts of them are
// clear (docs/decisions/0069-what-stopped-the-light-last.md).
#pragma once

#include <functional>

#include "tracer/world/world_builder.h"

namespace durer {

// Whether a caster lets no light through where a ray of the world hits it from outside.
using StopsLight = std::function<bool(const RememberedCaster& caster, const GeometryRay& ray,
                                      const ShapeHit& hit)>;

// Of the scene, by textures and by what can be seen from outside; none if there are many.
std::vector<RememberedCaster> find_remembered_casters(const WorldData& data,
                                                      const StopsLight& stops_light);

// The nearest hit, 1e-4 <= t < max_t, of a shadow ray with any of them; the caster, or null.
const RememberedCaster* closest_of_remembered(const WorldData& data,
                                              const std::vector<RememberedCaster>& casters,
                                              const GeometryRay& ray, double max_t, HitStack& stack,
                                              ShapeHit& hit);

}  // namespace durer
