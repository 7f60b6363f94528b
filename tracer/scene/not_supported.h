// Thrown while a scene is made ready for rays when something visible needs a feature that is parsed
// but not rendered yet (design.md rule 7). The command prints `file:line: not supported yet: X` and
// exits with status 3.
#pragma once

#include <stdexcept>
#include <string>

#include "tracer/scene/source_position.h"

namespace durer {

class NotSupported : public std::runtime_error {
 public:
  NotSupported(const std::string& feature, SourcePosition where)
      : std::runtime_error(feature), position(std::move(where)) {}

  SourcePosition position;
};

}  // namespace durer
