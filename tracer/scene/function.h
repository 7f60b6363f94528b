// A function{} as an identifier holds it: compiled and immutable.
#pragma once

#include <memory>
#include <string>

#include "tracer/scene/source_position.h"

namespace durer {

class CompiledFunction;  // tracer/functions/compiled_function.h

struct FunctionNode {
  std::shared_ptr<const CompiledFunction> compiled;
  std::string name;
  SourcePosition position;
};

}  // namespace durer
