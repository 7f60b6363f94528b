// What stands in a map's brackets after the place, or in the braces of a list's item: the inside of a
// pigment, normal, texture or density (spec/textures.md 15.1).
#pragma once

#include "parser/statements/textures.h"

namespace durer {

std::shared_ptr<const PigmentNode> parse_pigment_entry(Parser& parser);
std::shared_ptr<const PigmentNode> parse_density_entry(Parser& parser);
std::shared_ptr<const NormalNode> parse_normal_entry(Parser& parser);
TexturePtr parse_texture_entry(Parser& parser);

}  // namespace durer
