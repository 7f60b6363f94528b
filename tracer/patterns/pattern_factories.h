// The factories of all patterns; each is defined in the pattern's own file and listed in
// pattern_registry.cpp.
#pragma once

#include "tracer/patterns/pattern.h"

namespace durer {

#define DURER_PATTERN(name) \
  std::unique_ptr<const BasePattern> make_##name(const PatternNode&, const PatternSettings&)
DURER_PATTERN(agate);
DURER_PATTERN(aoi);
DURER_PATTERN(boxed);
DURER_PATTERN(bozo);
DURER_PATTERN(brick);
DURER_PATTERN(cells);
DURER_PATTERN(checker);
DURER_PATTERN(crackle);
DURER_PATTERN(cubic);
DURER_PATTERN(cylindrical);
DURER_PATTERN(density_file);
DURER_PATTERN(dents);
DURER_PATTERN(facets);
DURER_PATTERN(function);
DURER_PATTERN(image_pattern);
DURER_PATTERN(gradient);
DURER_PATTERN(granite);
DURER_PATTERN(hexagon);
DURER_PATTERN(julia);
DURER_PATTERN(leopard);
DURER_PATTERN(magnet_julia);
DURER_PATTERN(magnet_mandel);
DURER_PATTERN(mandel);
DURER_PATTERN(marble);
DURER_PATTERN(object);
DURER_PATTERN(onion);
DURER_PATTERN(pavement);
DURER_PATTERN(pigment_pattern);
DURER_PATTERN(planar);
DURER_PATTERN(quilted);
DURER_PATTERN(radial);
DURER_PATTERN(ripples);
DURER_PATTERN(slope);
DURER_PATTERN(spherical);
DURER_PATTERN(spiral1);
DURER_PATTERN(spiral2);
DURER_PATTERN(square);
DURER_PATTERN(tiling);
DURER_PATTERN(triangular);
DURER_PATTERN(waves);
DURER_PATTERN(wood);
DURER_PATTERN(wrinkles);
#undef DURER_PATTERN

}  // namespace durer
