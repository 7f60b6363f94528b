// image_map: pixels as colours (spec/textures.md 12).
#pragma once

#include "tracer/texture/surface_texture.h"

namespace durer {

std::shared_ptr<const CompiledPigment> compile_image_pigment(const PigmentNode& node,
                                                             const TextureSettings& settings);

}  // namespace durer
