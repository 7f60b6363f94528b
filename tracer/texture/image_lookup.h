// image_map: pixels as colours; material_map: pixels as numbers of textures (spec/textures.md 12).
#pragma once

#include "tracer/texture/surface_texture.h"

namespace durer {

// Both throw std::runtime_error with a text for the user if the image cannot be read.
std::unique_ptr<const CompiledPigment> compile_image_pigment(const PigmentNode& node,
                                                             const TextureSettings& settings);
std::unique_ptr<const TextureSelector> make_material_selector(
    const TextureNode& node, std::vector<std::shared_ptr<const CompiledTexture>> materials,
    const TextureSettings& settings);

}  // namespace durer
