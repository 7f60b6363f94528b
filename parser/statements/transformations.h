// translate, rotate, scale, matrix, transform (spec/language.md 22).
#pragma once

#include "tracer/math/transform.h"

namespace durer {

class Parser;

// If the next token starts a transformation: reads it. False, nothing consumed, otherwise.
bool accept_transformation(Parser& parser, Transform& transform);
// All that follow, composed in order; identity if none.
Transform parse_transformations(Parser& parser);

}  // namespace durer
