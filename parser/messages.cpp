// Errors and warnings of the parser: place, line with caret, chain of macros and includes, hints.
#include <algorithm>
#include <cstdio>

#include "parser/parser_state.h"

namespace durer {
namespace {

// Levenshtein's distance, given up above `most`.
int edit_distance(std::string_view a, std::string_view b, int most) {
  if (a.size() > b.size() + static_cast<size_t>(most) || b.size() > a.size() + static_cast<size_t>(most)) {
    return most + 1;
  }
  std::vector<int> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const int above = row[j];
      row[j] = std::min({row[j - 1] + 1, above + 1, diagonal + (a[i - 1] != b[j - 1])});
      diagonal = above;
    }
  }
  return row[b.size()];
}

const char* symbol_text(Symbol symbol) {
  static constexpr const char* kText[] = {
      "{", "}", "(", ")", "[", "]", "<", ">", "<=", ">=", "=", "!=", "+", "-", "*", "/", "&", "|",
      "!", "?", ":", ";", ",", ".", "#", "@", "$", "%", "^", "~", "\\", "`", "'"};
  return kText[static_cast<int>(symbol)];
}

}  // namespace

// What the token read last is, for "expected X, found Y".
std::string Parser::State::found() {
  const Token& token = look.token;
  switch (token.kind) {
    case TokenKind::end_of_file: return "the end of the file";
    case TokenKind::keyword: return quoted(token.name);
    case TokenKind::identifier: {
      const std::string name = quoted(token.name);
      if (!look.value) return name + ", which is not declared";
      return std::string(kind_name(look.value->kind())) + " " + name;
    }
    case TokenKind::number: {
      char text[32];
      std::snprintf(text, sizeof text, "%g", token.number);
      return std::string("the number ") + text;
    }
    case TokenKind::string: return "a string";
    case TokenKind::symbol: return std::string("'") + symbol_text(token.symbol) + "'";
    case TokenKind::malformed: return "something unreadable";
  }
  return {};
}

std::string Parser::State::quoted(Name name) const {
  std::string text(1, '\'');
  text += names.text(name);
  text += '\'';
  return text;
}

std::string Parser::State::suggestion(Name name) {
  const std::string_view wanted = names.text(name);
  const int most = wanted.size() < 4 ? 1 : wanted.size() < 8 ? 2 : 3;
  int best = most + 1;
  std::string_view nearest;
  const auto consider = [&](std::string_view candidate) {
    const int distance = edit_distance(wanted, candidate, most);
    if (distance < best && distance > 0) best = distance, nearest = candidate;
  };
  symbols.for_each_name([&](Name known) { consider(names.text(known)); });
  for (int k = 0; k < kKeywordCount; ++k) consider(spelling(static_cast<Keyword>(k)));
  if (nearest.empty()) return {};
  return "did you mean '" + std::string(nearest) + "'?";
}

Diagnostic Parser::State::diagnostic_here(Severity severity, const std::string& text) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.text = text;
  if (!last_file) return diagnostic;
  diagnostic.file = last_file->name();
  diagnostic.line = last_file->line_of(last_offset);
  diagnostic.column = last_file->column_of(last_offset);
  diagnostic.source_line = last_file->line_text(diagnostic.line);
  // The way here, innermost first: each frame's place is where its caller goes on.
  for (size_t i = frames.size(); i-- > 1;) {
    DiagnosticFrame frame;
    Frame& caller = frames[i - 1];
    frame.description =
        frames[i].macro ? "in macro " + std::string(names.text(frames[i].macro->name)) + ", called"
                        : "in " + frames[i].file->name() + ", included";
    frame.file = caller.file->name();
    const Token* begin = caller.page->tokens.data();
    const uint32_t offset = caller.at > begin ? caller.at[-1].offset : caller.page->begin;
    frame.line = caller.file->line_of(offset);
    diagnostic.frames.push_back(std::move(frame));
  }
  return diagnostic;
}

void Parser::State::error(const std::string& text, const std::string& hint) {
  Diagnostic diagnostic = diagnostic_here(Severity::error, text);
  diagnostic.hint = hint;
  throw ParseError(std::move(diagnostic));
}

void Parser::State::error_expected(std::string_view what) {
  std::string hint;
  if (look.token.kind == TokenKind::identifier && !look.value) hint = suggestion(look.token.name);
  if (look.token.kind == TokenKind::identifier && look.value &&
      look.value->kind() == ValueKind::macro) {
    hint = "macros are not expanded between an operand and what follows it here; put the value "
           "into parentheses";
  }
  error("expected " + std::string(what) + ", found " + found(), hint);
}

void Parser::State::raise_lexical(const Token& token) {
  const SourceFile& file = *frames.back().file;
  switch (token.error) {
    case LexicalError::illegal_character: {
      char text[96];
      std::snprintf(text, sizeof text, "illegal character 0x%02x outside strings and comments",
                    static_cast<unsigned char>(file.text()[token.offset]));
      error(text);
    }
    case LexicalError::unterminated_comment:
      error("this comment has no end: */ is missing");
    case LexicalError::unterminated_string:
      error("this string has no end: the closing quote is missing");
    case LexicalError::string_newline:
      error("a backslash at the end of a line cannot continue a string");
    case LexicalError::string_too_long:
      error("a string in the text has at most 255 characters", "join shorter ones with concat()");
    case LexicalError::name_too_long:
      error("an identifier has at most 255 characters");
    case LexicalError::second_period:
      error("this number has a second decimal point",
            "for a component of a number write (5).x with parentheses");
  }
  error("unreadable text");
}

void Parser::State::message(Severity severity, const std::string& text) {
  if (!options.sink) return;
  options.sink->diagnostic(diagnostic_here(severity, text));
}

SourcePosition Parser::State::position() {
  if (!last_file) return {};
  return {last_file->shared_name(), last_file->line_of(last_offset), last_file->column_of(last_offset)};
}

size_t line_break(const std::string& text, size_t width) {
  for (size_t end = width; end > width - width / 4; --end) {
    if (text[end] == ' ') return end;
  }
  return width;
}

std::string Diagnostic::formatted() const {
  std::string out;
  if (!file.empty()) {
    out += file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
  }
  out += severity == Severity::error            ? "error: "
         : severity == Severity::possible_error ? "possible error: "
                                                : "warning: ";
  out += text + "\n";
  if (!source_line.empty()) {
    // A window of the line around the caret, tabs and control characters as spaces.
    constexpr size_t kWidth = 96;
    const size_t caret = static_cast<size_t>(column > 0 ? column - 1 : 0);
    const size_t begin = caret > kWidth * 3 / 4 ? caret - kWidth * 3 / 4 : 0;
    std::string window = source_line.substr(std::min(begin, source_line.size()), kWidth);
    for (char& c : window) {
      if (static_cast<unsigned char>(c) < 32) c = ' ';
    }
    out += "  " + window + "\n  " + std::string(std::min(caret - begin, kWidth), ' ') + "^\n";
  }
  if (!hint.empty()) out += "  hint: " + hint + "\n";
  // A deep recursion shows its ends.
  for (size_t i = 0; i < frames.size(); ++i) {
    if (frames.size() > 12 && i == 8) {
      out += "  ... " + std::to_string(frames.size() - 10) + " more\n";
      i = frames.size() - 2;
    }
    out += "  " + frames[i].description + " at " + frames[i].file + ":" +
           std::to_string(frames[i].line) + "\n";
  }
  return out;
}

}  // namespace durer
