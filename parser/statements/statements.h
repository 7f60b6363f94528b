// What the core of the parser asks of the statements. Implemented in this folder.
#pragma once

#include <memory>

#include "parser/value.h"
#include "tracer/math/transform.h"

namespace durer {

class Parser;
struct PatternNode;
struct PigmentNode;

// The scene file from its first token to its end: fills parser.scene(). Directives have been
// executed on the way by the cursor; the checks after the last token that concern versions and
// messages (spec/language.md 27: 2, 3, 5, 6) are the core's, all others belong here.
void parse_scene_statements(Parser& parser);

// The right-hand side of #declare, a macro argument or an array element that starts with the keyword
// of a block, or of anything else that is not a number, colour, string, array, spline or function:
// `texture{}` (also several: layers), `object{}`, `sphere{}`, `transform ...`, `fog{}`, ... Bare
// identifiers (`#declare A = B`) are done by the core. Returns an unset value, having consumed
// nothing, if the next token starts nothing of that kind.
Value parse_rvalue_block(Parser& parser);

// After `#default`: { ... }.
void parse_default_block(Parser& parser);

// Blocks inside function{}: the keyword has been read, the brace has not.
std::shared_ptr<const PatternNode> parse_function_pattern(Parser& parser);   // pattern { ... }
std::shared_ptr<const PigmentNode> parse_function_pigment(Parser& parser);   // pigment { ... }
Transform parse_transform_block(Parser& parser);                             // transform { ... }

}  // namespace durer
