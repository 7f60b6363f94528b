// warp{}, turbulence and transformations of patterns (spec/textures.md 3.1, 5).
#pragma once

#include "tracer/scene/pattern.h"

namespace durer {

class Parser;

bool accept_warp(Parser& parser, PatternNode& node);
// `turbulence`, `octaves`, `omega`, `lambda`: true if one was read into `turbulence`.
bool accept_turbulence_item(Parser& parser, Turbulence& turbulence);

}  // namespace durer
