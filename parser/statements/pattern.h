// Patterns as pigments, normals, textures and densities read them (spec/textures.md 3-9, 17).
#pragma once

#include "tracer/scene/pattern.h"

namespace durer {

class Parser;
enum class Keyword : uint16_t;

// Where a pattern stands decides which keywords exist.
enum class PatternUse : uint8_t { pigment, normal, texture, density, function };

// If a pattern's keyword comes next: reads it with its own arguments, up to the list or amount that
// may follow. Lists are the caller's (see list_length).
bool accept_pattern(Parser& parser, PatternNode& node, PatternUse use);
// The kind of a pattern that is this keyword and nothing else; none: there is no such pattern.
PatternKind simple_pattern(Keyword keyword);
// turbulence, warps, waves, transformations and the parameters of single patterns.
bool accept_pattern_modifier(Parser& parser, PatternNode& node);
// What the parameters must be together, once all of them are read.
void check_pattern(Parser& parser, const PatternNode& node);
// How many items a list pattern takes (checker 2, ...); 0: no list pattern.
int list_length(PatternKind kind);

}  // namespace durer
