// #macro: where its body stands and what its parameters are called (spec/language.md 14).
#pragma once

#include <memory>
#include <vector>

#include "parser/source.h"

namespace durer {

struct Macro {
  Name name = 0;
  std::vector<Name> parameters;
  std::shared_ptr<SourceFile> file;
  uint32_t body = 0;  // byte offset behind the parameter list
  mutable uint32_t body_token = 0;  // for Parser::State::seek()
};

}  // namespace durer
