// #declare, #local, #undef, #include, #version and the message directives (spec/language.md 12-19).
#include <cmath>

#include "parser/parser_state.h"
#include "parser/statements/statements.h"

namespace durer {

// The `#` has been read; the stream is live.
void Parser::State::execute_directive() {
  struct Directive {
    Keyword word;
    void (*run)(State&);
  };
  static constexpr Directive kDirectives[] = {
      {Keyword::declare, [](State& s) { s.do_declare(false); }},
      {Keyword::local, [](State& s) { s.do_declare(true); }},
      {Keyword::if_, [](State& s) { s.do_if(); }},
      {Keyword::ifdef, [](State& s) { s.do_ifdef(true); }},
      {Keyword::ifndef, [](State& s) { s.do_ifdef(false); }},
      {Keyword::else_, [](State& s) { s.do_else(); }},
      {Keyword::elseif, [](State& s) { s.do_elseif(); }},
      {Keyword::end, [](State& s) { s.do_end(); }},
      {Keyword::while_, [](State& s) { s.do_while(); }},
      {Keyword::for_, [](State& s) { s.do_for(); }},
      {Keyword::switch_, [](State& s) { s.do_switch(); }},
      {Keyword::case_, [](State& s) { s.do_case(false); }},
      {Keyword::range, [](State& s) { s.do_case(true); }},
      {Keyword::break_, [](State& s) { s.do_break(); }},
      {Keyword::macro, [](State& s) { s.do_macro(); }},
      {Keyword::undef, [](State& s) { s.do_undef(); }},
      {Keyword::include, [](State& s) { s.do_include(); }},
      {Keyword::version, [](State& s) { s.do_version(); }},
      {Keyword::default_, [](State& s) { parse_default_block(s.parser); }},
      {Keyword::fopen, [](State& s) { s.do_fopen(); }},
      {Keyword::fclose, [](State& s) { s.do_fclose(); }},
      {Keyword::read, [](State& s) { s.do_read(); }},
      {Keyword::write, [](State& s) { s.do_write(); }},
      {Keyword::debug, [](State& s) { s.do_message(Keyword::debug); }},
      {Keyword::warning, [](State& s) { s.do_message(Keyword::warning); }},
      {Keyword::error, [](State& s) { s.do_message(Keyword::error); }},
      {Keyword::render, [](State& s) { s.do_message(Keyword::render); }},
      {Keyword::statistics, [](State& s) { s.do_message(Keyword::statistics); }},
  };
  // The word is not looked up: a macro of the same name cannot come between.
  const Token word = raw_peek();
  if (word.kind == TokenKind::identifier && !symbols.find(word.name)) {
    raw_next();
    error("there is no directive #" + std::string(names.text(word.name)));
  }
  // A `#` before anything else that could stand there is passed over, as POV-Ray does, but for numbers.
  const Value* value = word.kind == TokenKind::identifier ? plain_value(word.name) : nullptr;
  const bool number = word.kind == TokenKind::number || (value && value->kind() == ValueKind::number);
  if (number) {
    raw_next();
    error("there is no directive that begins with a number");
  }
  if (word.kind != TokenKind::keyword) return;
  for (const Directive& directive : kDirectives) {
    if (directive.word != word.keyword) continue;
    raw_next();
    return directive.run(*this);
  }
}

// At the level of the scene some directives work without their `#`.
bool Parser::State::accept_bare_directive() {
  const Token word = peek();
  if (word.kind != TokenKind::keyword) return false;
  switch (word.keyword) {
    case Keyword::declare:
      message(Severity::warning, "there should be a '#' before 'declare'");
      if (language_version >= 350) {
        message(Severity::possible_error, "'declare' should be changed to '#declare'");
      }
      consume();
      do_declare(false);
      return true;
    case Keyword::include:
      message(Severity::warning, "there should be a '#' before 'include'");
      consume();
      do_include();
      return true;
    case Keyword::default_:
      consume();
      parse_default_block(parser);
      return true;
    default:
      return false;
  }
}

void Parser::State::do_declare(bool local) {
  // The value may come from a macro whose own scope is still open when it is stored.
  const uint32_t scope = local ? symbols.innermost() : 0;
  std::unique_ptr<Deprecation> deprecation;
  Name name = 0;
  Reference target;
  bool is_element = false, discarded = false;
  {
    const FlagScope off(directives_live, false);
    const FlagScope plain(resolve_elements, false);
    if (accept(Keyword::deprecated)) {
      deprecation = std::make_unique<Deprecation>();
      deprecation->once = accept(Keyword::once);
      if (starts_string()) {
        const FlagScope elements(resolve_elements, true);
        deprecation->text = to_bytes(parse_string());
      }
    }
    const Token& token = peek();
    if (token.is(Symbol::paren_open)) {
      error("assigning to several names at once is syntax of POV-Ray 3.8, and this program reads the language of version 3.7");
    }
    if (token.kind != TokenKind::identifier) error_expected("an identifier to declare");
    if (look.value && look.value->kind() == ValueKind::macro) {
      error(quoted(token.name) + " is a macro: #declare cannot replace it");
    }
    name = token.name;
    Entry* entry = look.entry;
    const bool array = look.value && look.value->kind() == ValueKind::array;
    consume();
    if (raw_peek().is(Symbol::bracket_open)) {
      if (!entry) error_undeclared(name);
      if (!array) error(quoted(name) + " is not an array");
      target = entry->alias ? *entry->alias : Reference{entry, 0, {}};
      const FlagScope elements(resolve_elements, true);
      parse_target_element(target);
      is_element = true;
      if (readable(target)->kind() == ValueKind::function) {
        error("this element holds a function already", "#undef it first");
      }
      // #local leaves the elements of arrays of outer scopes alone that are set already.
      discarded = local && !entry->alias && entry->scope != scope && readable(target)->is_set();
    } else {
      target = begin_declaration(name, local, scope);
    }
    if (!peek().is(Symbol::equal)) error_expected("'='");
    consume();
    if (deprecation && deprecation->text.empty()) {
      deprecation->text = quoted(name) + " is declared deprecated";
    }
  }
  const bool created = !is_element && !readable(target)->is_set();
  // Reading the value may end the scope that the variable is in.
  SymbolTable::hold(*target.entry);
  RightSide right;
  {
    const FlagScope off(directives_live, false);
    const Name outer = declaring;
    declaring = name;
    parse_right_side(right, "a value to declare");
    declaring = outer;
    if (right.is_reference) {
      // A bare identifier: `#declare A = B` copies the value.
      const Value* value = readable(right.reference);
      if (!value || !value->is_set()) error("the value to assign is not set");
      right.value = *value;
    }
  }
  // Stored before `;` is looked for: what follows may be the #end of the macro whose parameter this
  // is.
  const bool numeric = right.numeric;
  if (numeric && language_version >= 350) {
    // Behind the name of a function or a spline directives are executed.
    const ValueKind kind = right.value.kind();
    const bool live = kind == ValueKind::function || kind == ValueKind::spline;
    const FlagScope off(directives_live, live);
    if (!peek().is(Symbol::semicolon)) check_semicolon(true);
  }
  if (is_element) {
    if (right.value.kind() == ValueKind::array) {
      const FlagScope off(directives_live, false);
      peek();
    }
    if (!discarded) store(target, std::move(right.value));
  } else if (Value* const slot = writable(target)) {
    // Not by store(): through a parameter even an element of an array may change its kind.
    *slot = std::move(right.value);
    if (created) target.entry->deprecation = std::move(deprecation);
  }
  symbols.drop(*target.entry);
  ++declarations;
  const FlagScope off(directives_live, false);
  check_semicolon(numeric);
}

// The subscripts of an element that is about to be set or removed. One that was never set is allowed,
// but no more behind a declaration inside the subscripts.
void Parser::State::parse_target_element(Reference& target) {
  const uint64_t before = declarations;
  parse_subscripts(target);
  if (declarations != before && !readable(target)->is_set()) {
    error("this array element was never set, and its subscripts declare something");
  }
}

// With directives off: `;` after a number is required, after anything else allowed.
void Parser::State::check_semicolon(bool numeric) {
  if (accept(Symbol::semicolon)) {
    if (numeric) accept(Symbol::semicolon);
    return;
  }
  if (!numeric) return;
  if (language_version >= 350) {
    error("expected ';' at the end of this declaration of a number, vector or colour",
          "write ';' behind the value");
  }
  if (language_version >= 310) {
    message(Severity::possible_error,
            "a declaration of a number, vector or colour should end with ';'");
  }
}

// The variable that is given a value. What #declare creates is there at once, without one:
// #ifdef finds it, and it hides an outer variable of its name, so that `#local A = A + 1` cannot read
// that one.
Reference Parser::State::begin_declaration(Name name, bool local, uint32_t scope) {
  Entry* const entry = symbols.find(name);
  const bool reachable = entry && (!local || entry->scope == scope);
  if (reachable && entry->alias) {
    if (!readable(*entry->alias)) error("the variable that " + quoted(name) + " stands for is gone");
    return *entry->alias;
  }
  if (entry && !entry->alias && entry->value.is_set()) {
    const ValueKind kind = entry->value.kind();
    if (kind == ValueKind::function) {
      error("function " + quoted(name) + " is declared already", "#undef it first");
    }
    if (kind == ValueKind::file) error(quoted(name) + " is an open file");
    if (reachable) return {entry, 0, {}};
  }
  return {&symbols.add(name, scope), 0, {}};
}

void Parser::State::do_undef() {
  const FlagScope off(directives_live, false);
  const FlagScope plain(resolve_elements, false);
  const Token& token = peek();
  if (token.kind != TokenKind::identifier) error_expected("an identifier to undefine");
  if (!look.value) {
    message(Severity::warning, "#undef of " + quoted(token.name) + ", which has no value");
    consume();
  } else {
    Entry& entry = *look.entry;
    const bool array = look.value && look.value->kind() == ValueKind::array;
    consume();
    if (array && raw_peek().is(Symbol::bracket_open)) {
      const FlagScope elements(resolve_elements, true);
      Reference target = entry.alias ? *entry.alias : Reference{&entry, 0, {}};
      parse_subscripts(target);
      Value* const element = writable(target);
      if (!element->is_set()) error("this array element was never set");
      *element = Value();
    } else {
      symbols.remove(entry);
    }
  }
}

void Parser::State::do_include() {
  const std::string name = [&] {
    const std::u16string text = parse_string(true);
    return to_bytes(text);
  }();
  if (static_cast<int>(frames.size()) >= options.limits.max_include_depth + options.limits.max_nesting) {
    error("too many nested files and macros");
  }
  int files = 1;
  for (const Frame& frame : frames) files += frame.macro ? 0 : 1;
  if (files > options.limits.max_include_depth) {
    error("includes are nested more than " + std::to_string(options.limits.max_include_depth) +
          " deep: does '" + name + "' include itself?");
  }
  if (static_cast<int>(symbols.nested()) >= options.limits.max_symbol_tables) {
    error_nested_macros();
  }
  const std::string path = find_file(name, FileType::include, true);
  if (path.empty()) {
    error("cannot find the include file '" + name + "'",
          "looked in the current folder and the library paths");
  }
  std::shared_ptr<SourceFile> file = load_source(path);
  symbols.push_scope();
  push_frame(std::move(file), 0, nullptr);
}

void Parser::State::do_version() {
  const bool is_first_token = consumed == 0;
  const FlagScope off(directives_live, false);
  // `unofficial` is no reserved word.
  if (peek().kind == TokenKind::identifier && names.text(look.token.name) == "unofficial") consume();
  const double number = parse_float();
  const double hundredths = std::trunc(100.0 * number + 0.5);
  if (!(hundredths <= 370)) {
    error("this scene is written for a later version of the language, and this program reads that of 3.7");
  }
  if (!version_seen) version_first = is_first_token;
  language_version = static_cast<int>(hundredths);
  version_seen = true;
  follow_noise_generator();
  if (accept(Symbol::semicolon)) return;
  if (ahead == kDeferred && look.token.kind == TokenKind::identifier) {
    error("expected ';' behind #version, found macro " + quoted(look.token.name));
  }
  if (language_version >= 310) message(Severity::possible_error, "#version should end with ';'");
}

void Parser::State::follow_noise_generator() {
  field_settings->noise_generator = scene.settings.noise_generator_given ? scene.settings.noise_generator
                                    : language_version < 350             ? 1
                                                                         : 2;
}

void Parser::State::do_message(Keyword which) {
  std::string text = to_bytes(parse_string());
  if (which == Keyword::render || which == Keyword::statistics) {
    message(Severity::warning,
            "#render and #statistics have no stream of their own any more: the text goes to the "
            "#debug stream");
    which = Keyword::debug;
  }
  if (which == Keyword::debug) {
    if (text.size() > 200) text = text.substr(0, 156) + "...";
    write_debug(text);
    return;
  }
  if (text.size() > 160) text = text.substr(0, 124) + "...";
  if (which == Keyword::error) error("#error: " + text);
  message(Severity::warning, "#warning: " + text);
}

// Lines are shown when complete, or when they are longer than a line can be.
void Parser::State::write_debug(const std::string& text) {
  constexpr size_t kLongest = 160;
  const auto show = [&](const std::string& line) {
    if (options.sink) options.sink->debug_line(line);
  };
  for (const char c : text) {
    if (c == '\n') {
      show(debug_line);
      debug_line.clear();
      continue;
    }
    debug_line += c;
    if (debug_line.size() > kLongest) {
      const size_t end = line_break(debug_line, kLongest);
      show(debug_line.substr(0, end));
      debug_line.erase(0, end);
    }
  }
}

}  // namespace durer
