#include "parser/lexer.h"

#include <charconv>
#include <cstdlib>

namespace durer {
namespace {

enum CharClass : uint8_t { kOther, kSpace, kLetter, kDigit, kHigh };

struct CharTable {
  uint8_t of[256];
  constexpr CharTable() : of() {
    for (int c = 0; c < 256; ++c) {
      const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
      const bool space = c == ' ' || (c >= '\t' && c <= '\r') || c == 0 || c == 0x1a;
      of[c] = letter ? kLetter : space ? kSpace : c >= '0' && c <= '9' ? kDigit : c > 127 ? kHigh : kOther;
    }
  }
};
constexpr CharTable kClass;

inline uint8_t class_of(char c) { return kClass.of[static_cast<unsigned char>(c)]; }
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Symbols of one character; hash stands for "none".
constexpr Symbol single_symbol(char c, bool& known) {
  known = true;
  switch (c) {
    case '{': return Symbol::brace_open;
    case '}': return Symbol::brace_close;
    case '(': return Symbol::paren_open;
    case ')': return Symbol::paren_close;
    case '[': return Symbol::bracket_open;
    case ']': return Symbol::bracket_close;
    case '<': return Symbol::less;
    case '>': return Symbol::greater;
    case '=': return Symbol::equal;
    case '+': return Symbol::plus;
    case '-': return Symbol::minus;
    case '*': return Symbol::star;
    case '/': return Symbol::slash;
    case '&': return Symbol::ampersand;
    case '|': return Symbol::bar;
    case '!': return Symbol::exclamation;
    case '?': return Symbol::question;
    case ':': return Symbol::colon;
    case ';': return Symbol::semicolon;
    case ',': return Symbol::comma;
    case '.': return Symbol::period;
    case '#': return Symbol::hash;
    case '@': return Symbol::at;
    case '$': return Symbol::dollar;
    case '%': return Symbol::percent;
    case '^': return Symbol::caret;
    case '~': return Symbol::tilde;
    case '\\': return Symbol::backslash;
    case '`': return Symbol::backquote;
    case '\'': return Symbol::apostrophe;
    default: known = false; return Symbol::hash;
  }
}

// Scans the number's extent by the language's rule (a sign or digits may follow one `e`; `1e` is 1)
// and converts it. `second_period` is set where POV-Ray complains.
void scan_number(const char* text, uint32_t at, uint32_t size, double& value, uint32_t& end,
                 bool& second_period) {
  uint32_t p = at;
  while (p < size && is_digit(text[p])) ++p;
  if (p < size && text[p] == '.') {
    ++p;
    while (p < size && is_digit(text[p])) ++p;
  }
  uint32_t significant = p;
  if (p < size && (text[p] == 'e' || text[p] == 'E')) {
    ++p;
    if (p < size && (text[p] == '+' || text[p] == '-')) ++p;
    const uint32_t digits = p;
    while (p < size && is_digit(text[p])) ++p;
    if (p > digits) significant = p;
  }
  second_period = p < size && text[p] == '.' && (p > at);
  // `5.` already took its period: only a further one is in the way, and `1 .x` has white space.
  if (second_period) {
    bool had_period = false;
    for (uint32_t i = at; i < p; ++i) had_period |= text[i] == '.' || text[i] == 'e' || text[i] == 'E';
    second_period = had_period;
  }
  end = p;
  // Short integers are the most frequent numbers by far.
  if (significant - at <= 9) {
    uint32_t integer = 0, i = at;
    for (; i < significant && is_digit(text[i]); ++i) integer = integer * 10 + (text[i] - '0');
    if (i == significant) {
      value = integer;
      return;
    }
  }
  const auto result = std::from_chars(text + at, text + significant, value);
  // Out of double's range: strtod's infinity or zero.
  if (result.ec != std::errc()) value = std::strtod(std::string(text + at, significant - at).c_str(), nullptr);
}

}  // namespace

uint32_t skip_space(const std::string& text, uint32_t at, uint32_t& open_comment) {
  const uint32_t size = static_cast<uint32_t>(text.size());
  open_comment = kNoComment;
  while (at < size) {
    if (class_of(text[at]) == kSpace) {
      ++at;
    } else if (text[at] == '/' && at + 1 < size && text[at + 1] == '/') {
      while (at < size && text[at] != '\n' && text[at] != '\r') ++at;
    } else if (text[at] == '/' && at + 1 < size && text[at + 1] == '*') {
      // Block comments nest.
      int depth = 1;
      const uint32_t begin = at;
      at += 2;
      while (at < size && depth > 0) {
        if (text[at] == '*' && at + 1 < size && text[at + 1] == '/') {
          --depth, at += 2;
        } else if (text[at] == '/' && at + 1 < size && text[at + 1] == '*') {
          ++depth, at += 2;
        } else {
          ++at;
        }
      }
      if (depth > 0) {
        open_comment = begin;
        return size;
      }
    } else {
      break;
    }
  }
  return at;
}

bool lex_number(const std::string& text, uint32_t at, double& value, uint32_t& end) {
  const uint32_t size = static_cast<uint32_t>(text.size());
  if (at >= size) return false;
  if (!is_digit(text[at]) && !(text[at] == '.' && at + 1 < size && is_digit(text[at + 1]))) return false;
  bool second_period = false;
  scan_number(text.data(), at, size, value, end, second_period);
  return !second_period;
}

uint32_t lex(const std::string& text, uint32_t from, size_t most, NameTable& names,
             std::vector<Token>& tokens) {
  const uint32_t size = static_cast<uint32_t>(text.size());
  const char* data = text.data();
  uint32_t at = from;
  const auto malformed = [&](LexicalError error) {
    Token& token = tokens.back();
    token.kind = TokenKind::malformed;
    token.number = 0;
    token.error = error;
  };
  for (size_t made = 0; made < most; ++made) {
    uint32_t open_comment = kNoComment;
    const uint32_t before = at;
    at = skip_space(text, at, open_comment);
    Token& token = tokens.emplace_back();
    token.offset = open_comment != kNoComment ? before : at;
    if (open_comment != kNoComment) {
      malformed(LexicalError::unterminated_comment);
      return size;
    }
    if (at >= size) return size;  // the token is end_of_file already
    const char c = data[at];
    switch (class_of(c)) {
      case kLetter: {
        uint32_t end = at + 1;
        while (end < size && (class_of(data[end]) == kLetter || class_of(data[end]) == kDigit)) ++end;
        if (end - at > 255) {
          malformed(LexicalError::name_too_long);
          return end;
        }
        token.name = names.intern(data + at, end - at);
        if (token.name < static_cast<Name>(kKeywordCount)) {
          token.kind = TokenKind::keyword;
          token.keyword = canonical(static_cast<Keyword>(token.name));
        } else {
          token.kind = TokenKind::identifier;
        }
        at = end;
        continue;
      }
      case kHigh:
        malformed(LexicalError::illegal_character);
        return at + 1;
      case kDigit:
      case kOther:
        break;
      default:
        break;
    }
    if (is_digit(c) || (c == '.' && at + 1 < size && is_digit(data[at + 1]))) {
      bool second_period = false;
      double value = 0;
      scan_number(data, at, size, value, at, second_period);
      token.kind = TokenKind::number;
      token.number = value;
      if (second_period) {
        malformed(LexicalError::second_period);
        return at;
      }
      continue;
    }
    if (c == '"') {
      uint32_t end = at + 1;
      uint32_t bytes = 0;
      LexicalError error = LexicalError::unterminated_string;
      bool closed = false;
      while (end < size) {
        if (data[end] == '"') {
          closed = true;
          break;
        }
        if (data[end] == '\\' && end + 1 < size) {
          if (data[end + 1] == '\n' || data[end + 1] == '\r') {
            error = LexicalError::string_newline;
            break;
          }
          // \" is one byte; any other escape still counts both.
          bytes += data[end + 1] == '"' ? 1 : 2;
          end += 2;
          continue;
        }
        ++end, ++bytes;
      }
      if (!closed || bytes > 255) {
        malformed(closed ? LexicalError::string_too_long : error);
        return end;
      }
      token.kind = TokenKind::string;
      token.number = 0;
      token.string = end - at + 1;
      at = end + 1;
      continue;
    }
    bool known = false;
    token.symbol = single_symbol(c, known);
    if (!known) {
      malformed(LexicalError::illegal_character);
      return at + 1;
    }
    token.kind = TokenKind::symbol;
    ++at;
    if (at < size && data[at] == '=') {
      if (c == '<') token.symbol = Symbol::less_equal, ++at;
      if (c == '>') token.symbol = Symbol::greater_equal, ++at;
      if (c == '!') token.symbol = Symbol::not_equal, ++at;
    }
  }
  return at;
}

}  // namespace durer
