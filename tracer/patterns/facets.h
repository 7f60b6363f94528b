// facets: a normal pattern with no value of its own (spec/textures.md 14.3).
#pragma once

#include "tracer/scene/pattern.h"

namespace durer {

// The bent normal at pattern point q; n is made a unit vector first. The result has any length.
Vec3 facets_normal(const FacetsParameters& facets, const Vec3& q, Vec3 n);

}  // namespace durer
