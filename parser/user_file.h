// A file opened by #fopen (spec/language.md 17).
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "parser/token.h"

namespace durer {

class NameTable;

struct UserFile {
  enum class Mode : uint8_t { read, write, append };

  ~UserFile();
  void close();

  Name name = 0;
  std::string path;
  Mode mode = Mode::read;
  // read: the text and the place of the next token.
  std::string text;
  uint32_t at = 0;
  // write, append; null when closed. Standard streams are flushed, not closed.
  std::FILE* stream = nullptr;
  bool is_standard_stream = false;
};

}  // namespace durer
