// Where in the text a node came from, for messages that arise after parsing.
#pragma once

#include <memory>
#include <string>

namespace durer {

struct SourcePosition {
  std::shared_ptr<const std::string> file;  // null: not from a file
  int line = 0;
  int column = 0;
};

}  // namespace durer
