// What the lexer makes of the text. A token is 16 bytes and knows its place by byte offset; line and
// column are worked out from the file's line table when somebody asks.
#pragma once

#include <cstdint>

#include "parser/keyword.h"

namespace durer {

// Number of an interned name. Keywords come first: name < kKeywordCount is the Keyword itself.
using Name = uint32_t;

enum class Symbol : uint8_t {
  brace_open, brace_close, paren_open, paren_close, bracket_open, bracket_close, less, greater,
  less_equal, greater_equal, equal, not_equal, plus, minus, star, slash, ampersand, bar, exclamation,
  question, colon, semicolon, comma, period, hash,
  // Recognised but legal nowhere.
  at, dollar, percent, caret, tilde, backslash, backquote, apostrophe,
};

enum class TokenKind : uint8_t {
  keyword,     // name = spelling as written, keyword = canonical form
  identifier,  // name
  number,      // number
  string,      // string: index into the file's list of literals, escapes not yet processed
  symbol,      // symbol
  // Not text that was read well: the cursor looks at these two more closely.
  end_of_file,
  malformed,  // error: raised when the cursor reaches it
};

enum class LexicalError : uint8_t {
  illegal_character, unterminated_comment, unterminated_string, string_newline, string_too_long,
  name_too_long, second_period,
};

struct Token {
  TokenKind kind = TokenKind::end_of_file;
  Symbol symbol = Symbol::hash;
  Keyword keyword = Keyword::aa_level;
  uint32_t offset = 0;  // of the first byte in the file
  union {
    double number = 0;
    Name name;
    uint32_t string;
    LexicalError error;
  };

  bool is(Symbol s) const { return kind == TokenKind::symbol && symbol == s; }
  bool is(Keyword k) const { return kind == TokenKind::keyword && keyword == k; }
};
static_assert(sizeof(Token) == 16);

}  // namespace durer
