// The colours of patterns that were given no map (spec/textures.md 10).
#pragma once

#include "tracer/scene/texture.h"

namespace durer {

const ColorMap& default_color_map(const PatternNode& pattern);

}  // namespace durer
