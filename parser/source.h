// A source file in memory: its text, its lines, and its tokens, lexed page by page when needed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "parser/compiled_expression.h"
#include "parser/names.h"
#include "parser/token.h"

namespace durer {

// A run of tokens. Pages can be thrown away and lexed again: they start between two tokens.
struct TokenPage {
  uint32_t begin = 0;  // byte range of the text that it covers; the next page starts at `end`
  uint32_t end = 0;
  uint32_t pins = 0;   // frames that read from it now
  uint64_t last_used = 0;
  uint32_t returns = 0;  // how often reading began somewhere in it: loops, macro calls
  std::vector<Token> tokens;  // the last page of a file ends with end_of_file
  std::unique_ptr<ExpressionCache> expressions;  // of pages that are read again and again
};

class SourceFile : public std::enable_shared_from_this<SourceFile> {
 public:
  SourceFile(std::string name, std::string text, NameTable& names);

  const std::string& name() const { return *name_; }
  const std::shared_ptr<const std::string>& shared_name() const { return name_; }
  const std::string& text() const { return text_; }

  // The page that contains the byte offset, lexed if need be. Keeps few unpinned pages alive.
  TokenPage& page_at(uint32_t offset);
  // 1-based line and column (in bytes) of a byte offset.
  int line_of(uint32_t offset);
  int column_of(uint32_t offset);
  std::string line_text(int line);
  // Body of the string literal whose opening quote is at the offset, with \" reduced to ".
  std::string literal_at(uint32_t offset) const;

  // Offset of the first token: past the leading bytes above 127 of a main file.
  uint32_t start = 0;

 private:
  void scan_lines_to(uint32_t offset);
  void drop_old_pages();

  std::shared_ptr<const std::string> name_;
  std::string text_;
  NameTable& names_;
  std::vector<std::unique_ptr<TokenPage>> pages_;  // by begin
  uint64_t clock_ = 0;
  std::vector<uint32_t> line_starts_{0};
  uint32_t lines_scanned_ = 0;
  size_t last_line_ = 1;  // that line_of() gave
};

// Whole content of a file. False: it cannot be read or is longer than the limit.
bool read_file(const std::string& path, uint64_t most_bytes, std::string& content);

}  // namespace durer
