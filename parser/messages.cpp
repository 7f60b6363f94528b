// Errors and warnings of the parser: place, line with caret, chain of macros and includes, hints.
#include <algorithm>
#include <cstdio>

#include "parser/edit_distance.h"
#include "parser/lexer.h"
#include "parser/parser_state.h"

namespace durer {
namespace {

// Words that later versions of the language know and this one does not.
bool is_later_syntax(std::string_view word) {
  static constexpr std::string_view kWords[] = {
      "akima_spline", "basic_x_spline", "blend_gamma",       "blend_mode",       "bt2020",
      "bt709",        "dictionary",     "extended_x_spline", "general_x_spline", "lemon",
      "mixed",        "optional",       "polarity",          "potential",        "sor_spline",
      "tau",          "tcb_spline",     "user_defined"};
  return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

std::string later_syntax(std::string_view word) {
  return "'" + std::string(word) +
         "' is syntax of POV-Ray 3.8, and this program reads the language of version 3.7";
}

// Offset of the token's last byte.
uint32_t last_byte_of(const SourceFile& file, uint32_t offset) {
  NameTable no_names;
  std::vector<Token> tokens;
  const uint32_t end = lex(file.text(), offset, 1, no_names, tokens);
  return end > offset && tokens[0].kind != TokenKind::malformed ? end - 1 : offset;
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
      if (!look.value) return name + (look.entry ? ", which has no value yet" : ", which is not declared");
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
  // One slip in three letters; in halves.
  const int most = 2 * static_cast<int>(std::clamp<size_t>(wanted.size() / 3, 1, 3));
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
  uint32_t offset = last_offset;
  if (behind_last) {
    offset = last_byte_of(*last_file, offset) + 1;
  } else if (offset < last_file->text().size() && last_file->text()[offset] == '"') {
    // A string over several lines is named by its last one.
    const uint32_t end = last_byte_of(*last_file, offset);
    if (last_file->line_of(end) != last_file->line_of(offset)) offset = end;
  }
  // Behind the last byte may be a new line already.
  const uint32_t before = behind_last && offset > 0 ? offset - 1 : offset;
  diagnostic.line = last_file->line_of(before);
  diagnostic.column = last_file->column_of(before) + static_cast<int>(offset - before);
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
    frame.line =
        caller.file->line_of(caller.at > begin ? caller.at[-1].offset : caller.page->begin);
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
  if (look.token.kind == TokenKind::identifier && !look.value) {
    if (is_later_syntax(names.text(look.token.name))) error(later_syntax(names.text(look.token.name)));
    hint = suggestion(look.token.name);
  }
  if (look.token.kind == TokenKind::identifier && look.value &&
      look.value->kind() == ValueKind::macro) {
    hint = "macros are not expanded between an operand and what follows it here; put the value "
           "into parentheses";
  }
  error("expected " + std::string(what) + ", found " + found(), hint);
}

void Parser::State::error_undeclared(Name name) {
  if (is_later_syntax(names.text(name))) error(later_syntax(names.text(name)));
  if (symbols.find(name)) {
    error(quoted(name) + " has no value yet",
          name == declaring ? "it is what is declared here, and hides an outer variable of this name" : "");
  }
  error(quoted(name) + " is not declared", suggestion(name));
}

void Parser::State::error_nested_macros() {
  error("macros and includes are nested too deeply (limit " +
            std::to_string(options.limits.max_symbol_tables) + ")",
        "--max-macro-depth N raises it, if the macros do not call each other without end");
}

void Parser::State::error_in_data(const std::string& path, const std::string& text, uint32_t offset,
                                  const std::string& what) {
  SourceFile data(path, text, names);
  Diagnostic diagnostic = diagnostic_here(Severity::error, what);
  DiagnosticFrame reader{"read", diagnostic.file, diagnostic.line};
  diagnostic.frames.insert(diagnostic.frames.begin(), std::move(reader));
  diagnostic.file = path;
  diagnostic.line = data.line_of(offset);
  diagnostic.column = data.column_of(offset);
  diagnostic.source_line = data.line_text(diagnostic.line);
  throw ParseError(std::move(diagnostic));
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
    case LexicalError::unterminated_comment: {
      uint32_t open = kNoComment;
      skip_space(file.text(), token.offset, open);
      error("a comment has no end: */ is missing",
            "it begins in line " + std::to_string(frames.back().file->line_of(open)));
    }
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
  static constexpr const char* kWords[] = {"note", "warning", "possible error", "error",
                                           "not supported yet"};
  out += kWords[static_cast<size_t>(severity)] + std::string(": ") + text + "\n";
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
  // A recursion shows each of its calls once, a deep one its ends.
  std::vector<std::string> chain;
  int repeated = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    std::string call = "  " + frames[i].description + " at " + frames[i].file + ":" +
                       std::to_string(frames[i].line);
    const bool same = !chain.empty() && chain.back() == call;
    repeated += same;
    if (!same) {
      if (repeated > 0) chain.back() += ", " + std::to_string(repeated + 1) + " times";
      repeated = 0;
      chain.push_back(std::move(call));
    }
  }
  if (repeated > 0) chain.back() += ", " + std::to_string(repeated + 1) + " times";
  for (size_t i = 0; i < chain.size(); ++i) {
    if (chain.size() > 12 && i == 8) {
      out += "  ... " + std::to_string(chain.size() - 10) + " more\n";
      i = chain.size() - 2;
    }
    out += chain[i] + "\n";
  }
  return out;
}

}  // namespace durer
