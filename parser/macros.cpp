// #macro and macro calls (spec/language.md 14). A body is replayed from its cached tokens.
#include <memory>
#include <vector>

#include "parser/parser_state.h"

namespace durer {
namespace {

constexpr size_t kMostParameters = 55;

std::string version_text(int hundredths) {
  const std::string digits = std::to_string(hundredths % 100);
  return std::to_string(hundredths / 100) + "." + (digits.size() < 2 ? "0" : "") + digits;
}

// `optional` is an ordinary name here, and the comma behind a parameter may be left out.
bool has_optional_parameter(const Macro& macro, const NameTable& names) {
  for (const Name parameter : macro.parameters) {
    if (names.text(parameter) == "optional") return true;
  }
  return false;
}

// Most macros have few parameters: no allocation for those.
template <typename Argument>
class ArgumentList {
 public:
  explicit ArgumentList(size_t count) : count_(count) {
    if (count > kFew) many_.resize(count);
    items_ = count > kFew ? many_.data() : reinterpret_cast<Argument*>(few_);
    if (count <= kFew) std::uninitialized_default_construct_n(items_, count);
  }
  ~ArgumentList() {
    if (count_ <= kFew) std::destroy_n(items_, count_);
  }
  ArgumentList(const ArgumentList&) = delete;
  ArgumentList& operator=(const ArgumentList&) = delete;

  Argument& operator[](size_t i) { return items_[i]; }

 private:
  static constexpr size_t kFew = 6;
  size_t count_;
  Argument* items_;
  std::vector<Argument> many_;
  alignas(Argument) std::byte few_[kFew * sizeof(Argument)];
};

}  // namespace

void Parser::State::do_macro() {
  if (language_version < 310) {
    error("macros need #version 3.1 or later, but #version " + version_text(language_version) +
          " is set");
  }
  const FlagScope off(directives_live, false);
  const FlagScope plain(resolve_elements, false);
  const Token name = peek();
  if (name.kind != TokenKind::identifier) error_expected("a name for the macro");
  if (look.value && look.value->kind() != ValueKind::macro) {
    error(quoted(name.name) + " is already declared as a " +
          kind_name(look.value->kind()) + ", a macro cannot take its name");
  }
  consume();
  auto macro = std::make_shared<Macro>();
  macro->name = name.name;
  expect(Symbol::paren_open);
  while (!peek().is(Symbol::paren_close)) {
    if (look.token.kind != TokenKind::identifier) error_expected("a parameter name or ')'");
    if (macro->parameters.size() >= kMostParameters) {
      error("a macro has at most " + std::to_string(kMostParameters) + " parameters");
    }
    macro->parameters.push_back(look.token.name);
    consume();
    accept_comma();
  }
  consume();
  macro->file = frames.back().file->shared_from_this();
  macro->body = last_offset + 1;
  Entry* entry = symbols.find(name.name);
  if (!entry || !entry->value.is_set()) entry = &symbols.add(name.name, 0);
  entry->value = Value(ValueKind::macro, std::shared_ptr<const Macro>(std::move(macro)));
  skip(1, false);
}

void Parser::State::error_few_arguments(const Macro& macro, size_t given) {
  if (has_optional_parameter(macro, names)) {
    error("optional parameters of macros are syntax of POV-Ray 3.8, and this program reads the "
          "language of version 3.7",
          "macro " + quoted(macro.name) + " has them");
  }
  const size_t count = macro.parameters.size();
  error("macro " + quoted(macro.name) + " takes " + std::to_string(count) +
            (count == 1 ? " argument" : " arguments") + ", only " + std::to_string(given) + " given",
        ahead == kDeferred ? "directives and macros do not act behind a number: a comma is missing before "
                             "this one"
                           : "");
}

void Parser::State::call_macro(const std::shared_ptr<const Macro>& macro) {
  if (language_version < 310) {
    error("macros need #version 3.1 or later, but #version " + version_text(language_version) +
          " is set");
  }
  const NestingScope deeper(*this);
  const uint32_t call = last_offset;
  const size_t count = macro->parameters.size();
  ArgumentList<RightSide> arguments(count);
  ahead = kNothing;
  ++directive_depth;
  expect(Symbol::paren_open);
  {
    // Directives and macros are executed where an argument or what follows a comma begins, and behind
    // arguments that are no numbers.
    const FlagScope off(directives_live, false);
    bool begins = true;
    for (size_t i = 0; i < count; ++i) {
      {
        const FlagScope live(directives_live, begins);
        peek();
      }
      if (ahead == kDeferred || look.token.is(Symbol::paren_close)) error_few_arguments(*macro, i);
      parse_right_side(arguments[i], "a macro argument");
      const FlagScope live(directives_live, !arguments[i].numeric && ahead != kDeferred);
      if (arguments[i].is_reference) keep_if_scope_ends(arguments[i]);
      begins = accept_comma();
    }
    const FlagScope live(directives_live, begins);
    if (!accept(Symbol::paren_close)) {
      error_expected("')' after the last argument of macro " + quoted(macro->name));
    }
    --directive_depth;
  }
  if (static_cast<int>(symbols.nested()) >= options.limits.max_symbol_tables) {
    error_nested_macros();
  }
  open_conditional(Conditional::Kind::macro_call, call);
  conditionals.back().frame = frames.size();
  symbols.push_scope();
  const uint32_t scope = symbols.innermost();
  for (size_t i = 0; i < count; ++i) {
    const Name parameter = macro->parameters[i];
    Entry& fresh = symbols.add(parameter, scope);  // hides one of the same name before it
    if (arguments[i].is_reference) {
      symbols.make_alias(fresh, arguments[i].reference);
    } else {
      fresh.value = std::move(arguments[i].value);
    }
  }
  // The call's lookahead is empty: the argument list ended with its parenthesis.
  push_frame(macro->file, macro->body, macro);
}

// Looking at what follows an argument may end the scope of a nested call that delivered it.
void Parser::State::keep_if_scope_ends(RightSide& argument) {
  Entry* entry = argument.reference.entry;
  if (argument.value.kind() == ValueKind::unset) argument.value = *readable(argument.reference);
  SymbolTable::hold(*entry);
  peek();
  if (!entry->live) argument.is_reference = false;
  symbols.drop(*entry);
}

void Parser::State::return_from_macro() {
  conditionals.pop_back();
  pop_frame();
}

}  // namespace durer
