// Text to tokens (spec/language.md 1-2).
#pragma once

#include <string>
#include <vector>

#include "parser/names.h"
#include "parser/token.h"

namespace durer {

// Appends at most `most` tokens, starting at byte `from`, and returns the offset where it stopped.
// At the end of the text it appends end_of_file; a malformed token ends the run, too.
uint32_t lex(const std::string& text, uint32_t from, size_t most, NameTable& names,
             std::vector<Token>& tokens);

// Past white space and comments. An unterminated comment gives the text's size, and its offset in
// `open_comment`, which is kNoComment otherwise.
constexpr uint32_t kNoComment = UINT32_MAX;
uint32_t skip_space(const std::string& text, uint32_t at, uint32_t& open_comment);

// One unsigned number at `at`: value and the offset behind it. False: no number stands there, or a
// second period follows it.
bool lex_number(const std::string& text, uint32_t at, double& value, uint32_t& end);

}  // namespace durer
