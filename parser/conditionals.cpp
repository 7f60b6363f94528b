// #if, #ifdef, #while, #for, #switch, #break and #end (spec/language.md 13).
#include <cmath>

#include "parser/parser_state.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

using Kind = Conditional::Kind;

}  // namespace

void Parser::State::open_conditional(Kind kind, uint32_t start) {
  if (static_cast<int>(conditionals.size()) >= options.limits.max_nesting) {
    error("too many nested conditionals, loops and macro calls (limit " +
              std::to_string(options.limits.max_nesting) + ")",
          "--max-macro-depth N raises it");
  }
  Conditional& conditional = conditionals.emplace_back();
  conditional.kind = kind;
  conditional.frame = frames.size() - 1;
  conditional.start = start;
}

void Parser::State::count_turn() {
  if (++loop_turns > options.limits.max_loop_turns) {
    error("the loops of this scene have turned more than " +
              std::to_string(options.limits.max_loop_turns) + " times, which is the limit",
          "--max-loop-turns N raises it");
  }
}

bool Parser::State::parse_condition() {
  const FlagScope off(directives_live, false);
  expect(Symbol::paren_open);
  const double value = parse_float_express();
  expect(Symbol::paren_close);
  return std::fabs(value) > kEpsilon;
}

// ( NAME ) or ( A[i]... ): the parentheses included.
bool Parser::State::parse_defined() {
  const FlagScope off(directives_live, false);
  expect(Symbol::paren_open);
  const FlagScope plain(resolve_elements, false);
  bool defined = false;
  // Whatever is no name in use is not defined.
  if (peek().kind == TokenKind::identifier && look.entry) {
    Entry& entry = *look.entry;
    defined = true;
    const bool is_array = look.value && look.value->kind() == ValueKind::array;
    consume();
    if (is_array && raw_peek().is(Symbol::bracket_open)) {
      const Value* value = readable(parse_element(entry));
      defined = value && value->is_set();
    }
  } else {
    consume();
    const FlagScope on(directives_live, true);
    peek();
  }
  expect(Symbol::paren_close);
  return defined;
}

Parser::State::Landing Parser::State::skip(int levels, bool stop_at_branches) {
  const int outermost = levels;
  for (;;) {
    const Token& token = raw_next();
    if (token.kind == TokenKind::end_of_file) {
      if (frames.size() == 1 || frames.back().macro) error("the file ended, but an #end is missing");
      pop_frame();
      continue;
    }
    if (!token.is(Symbol::hash)) continue;
    const Token* word = &raw_next();
    while (word->is(Symbol::hash)) word = &raw_next();
    if (word->kind != TokenKind::keyword) continue;
    switch (word->keyword) {
      case Keyword::if_:
      case Keyword::ifdef:
      case Keyword::ifndef:
      case Keyword::while_:
      case Keyword::for_:
      case Keyword::switch_:
      case Keyword::macro:
        ++levels;
        break;
      case Keyword::end:
        if (--levels == 0) return Landing::end;
        break;
      case Keyword::else_:
        if (stop_at_branches && levels == outermost) return Landing::else_branch;
        break;
      case Keyword::elseif:
        if (stop_at_branches && levels == outermost) return Landing::elseif_branch;
        break;
      case Keyword::case_:
        if (stop_at_branches && levels == outermost) return Landing::case_label;
        break;
      case Keyword::range:
        if (stop_at_branches && levels == outermost) return Landing::range_label;
        break;
      case Keyword::render:
      case Keyword::statistics:
        message(Severity::warning,
                "#render and #statistics have no stream of their own any more: the text goes to "
                "the #debug stream");
        break;
      default:
        break;
    }
  }
}

void Parser::State::do_if() {
  const uint32_t start = last_offset;
  if (parse_condition()) {
    open_conditional(Kind::if_taken, start);
  } else {
    open_conditional(Kind::if_taken, start);
    skip_after_failed_if();
  }
}

void Parser::State::do_ifdef(bool wanted) {
  const uint32_t start = last_offset;
  const bool defined = parse_defined();
  open_conditional(Kind::if_taken, start);
  if (defined != wanted) skip_after_failed_if();
}

// The innermost conditional is an #if whose condition was false: goes to the branch that is taken.
void Parser::State::skip_after_failed_if() {
  for (;;) {
    switch (skip(1, true)) {
      case Landing::end:
        conditionals.pop_back();
        return;
      case Landing::else_branch:
        conditionals.back().kind = Kind::else_taken;
        return;
      case Landing::elseif_branch:
        if (parse_condition()) return;
        break;
      case Landing::case_label:
      case Landing::range_label:
        break;
    }
  }
}

void Parser::State::do_else() {
  if (conditionals.empty()) error("#else without an #if before it");
  switch (conditionals.back().kind) {
    case Kind::if_taken:
      skip(1, false);
      conditionals.pop_back();
      return;
    case Kind::switch_matched:
      return;  // falls through
    default:
      error("this #else does not belong to an #if or a #case");
  }
}

void Parser::State::do_elseif() {
  if (conditionals.empty() || conditionals.back().kind != Kind::if_taken) {
    error("this #elseif does not belong to an #if");
  }
  skip(1, false);
  conditionals.pop_back();
}

void Parser::State::do_while() {
  // The condition stands right behind the word: its text is read again before each turn.
  const uint32_t start = last_offset + 5;
  open_conditional(Kind::while_loop, start);
  if (parse_condition()) {
    count_turn();
    return;
  }
  skip(1, false);
  conditionals.pop_back();
}

void Parser::State::do_for() {
  const uint32_t directive = last_offset;
  expect(Symbol::paren_open);
  Name variable = 0;
  {
    const FlagScope off(directives_live, false);
    const FlagScope plain(resolve_elements, false);
    if (peek().kind != TokenKind::identifier) error_expected("a name for the loop variable");
    if (look.value && look.value->kind() == ValueKind::array && raw_peek().is(Symbol::bracket_open)) {
      error("an array element cannot be the variable of a #for loop");
    }
    variable = look.token.name;
    const ValueKind kind = look.value ? look.value->kind() : ValueKind::unset;
    if (kind == ValueKind::macro || kind == ValueKind::file) {
      error(quoted(variable) + " is a " + kind_name(kind) +
            ", it cannot be the variable of a #for loop");
    }
    if (kind == ValueKind::function) {
      error("function " + quoted(variable) + " is declared already", "#undef it first");
    }
    consume();
  }
  // The variable is there, and 0, while its start is read.
  Entry* entry = symbols.find(variable);
  if (!entry || entry->scope != symbols.innermost()) {
    entry = &symbols.add(variable, symbols.innermost());
  }
  const auto counter = [&]() -> Value& {
    Value* const value = entry->alias ? writable(*entry->alias) : &entry->value;
    if (!value) error("the variable that " + quoted(variable) + " stands for is gone");
    return *value;
  };
  counter() = Value(0.0);
  accept_comma();
  const double first = parse_float();
  counter() = Value(first);
  accept_comma();
  const double end = parse_float();
  double step = 1;
  accept_comma();
  if (!peek().is(Symbol::paren_close)) step = parse_float();
  expect(Symbol::paren_close);
  if (std::fabs(step) < kEpsilon) error("the step of a #for loop must not be zero");

  const uint32_t body = last_offset + 1;  // behind the parenthesis
  open_conditional(Kind::for_loop, directive);
  Conditional& loop = conditionals.back();
  loop.start = body;
  loop.variable = variable;
  loop.end = end;
  loop.step = step;
  const double start = counter().number();
  const bool runs = (step > 0 && start < end + kEpsilon) || (step < 0 && start > end - kEpsilon);
  if (runs) {
    count_turn();
    return;
  }
  skip(1, false);
  conditionals.pop_back();
}

void Parser::State::do_switch() {
  const uint32_t start = last_offset;
  const FlagScope off(directives_live, false);
  expect(Symbol::paren_open);
  const double value = parse_float_express();
  expect(Symbol::paren_close);
  open_conditional(Kind::switch_waiting, start);
  conditionals.back().switch_value = value;
  conditionals.back().directive_depth = directive_depth - 1;
  ++waiting_switches;
}

bool Parser::State::parse_case_label(bool range, double value) {
  const FlagScope off(directives_live, false);
  expect(Symbol::paren_open);
  bool matches = false;
  if (range) {
    const double low = parse_float();
    accept_comma();
    const double high = parse_float();
    matches = low <= value && value <= high;
  } else {
    matches = std::fabs(parse_float_express() - value) < kEpsilon;
  }
  expect(Symbol::paren_close);
  return matches;
}

void Parser::State::do_case(bool range) {
  if (conditionals.empty()) error("a #case or #range belongs into a #switch");
  const size_t index = conditionals.size() - 1;
  const Kind kind = conditionals[index].kind;
  if (kind != Kind::switch_waiting && kind != Kind::switch_matched) {
    error("this #case or #range does not belong to a #switch");
  }
  const bool matches = parse_case_label(range, conditionals[index].switch_value);
  if (kind == Kind::switch_matched) return;  // falls through
  --waiting_switches;
  conditionals[index].kind = Kind::switch_matched;
  if (!matches) skip_to_matching_label(index);
}

void Parser::State::skip_to_matching_label(size_t conditional) {
  for (;;) {
    const Landing landing = skip(1, true);
    switch (landing) {
      case Landing::end:
        conditionals.pop_back();
        return;
      case Landing::else_branch:
        return;
      case Landing::case_label:
      case Landing::range_label:
        if (parse_case_label(landing == Landing::range_label, conditionals[conditional].switch_value)) {
          return;
        }
        break;
      case Landing::elseif_branch:
        error("this #elseif does not belong to an #if");
    }
  }
}

void Parser::State::do_break() {
  // How many levels deep inside the construct that it leaves.
  int levels = 1;
  for (size_t i = conditionals.size(); i-- > 0;) {
    switch (conditionals[i].kind) {
      case Kind::if_taken:
      case Kind::else_taken:
        ++levels;
        continue;
      case Kind::macro_call:
        conditionals.resize(i + 1);
        return_from_macro();
        return;
      case Kind::switch_waiting:
        error("expected #case or #range after #switch");
      case Kind::while_loop:
      case Kind::for_loop:
      case Kind::switch_matched:
        // Files that were included inside it end with it.
        conditionals.resize(i + 1);
        skip(levels, false);
        conditionals.pop_back();
        return;
    }
  }
  error("there is no loop, #switch or macro here that #break could leave");
}

void Parser::State::do_end() {
  if (conditionals.empty()) error("#end without anything that it could end");
  const size_t index = conditionals.size() - 1;
  Conditional& loop = conditionals[index];
  switch (loop.kind) {
    case Kind::macro_call:
      return_from_macro();
      return;
    case Kind::if_taken:
    case Kind::else_taken:
    case Kind::switch_matched:
      conditionals.pop_back();
      return;
    case Kind::switch_waiting:
      error("expected #case or #range after #switch");
    case Kind::while_loop: {
      if (loop.frame != frames.size() - 1) error("this #while loop began in another file");
      const uint32_t behind = last_offset + 3;
      seek(frames.back(), loop.start, loop.start_token);
      if (parse_condition()) {
        count_turn();
      } else {
        conditionals.pop_back();
        seek(frames.back(), behind);
      }
      return;
    }
    case Kind::for_loop: {
      if (loop.frame != frames.size() - 1) error("this #for loop began in another file");
      Entry* entry = symbols.find(loop.variable);
      if (!entry || entry->scope != symbols.innermost() ||
          entry->value.kind() != ValueKind::number) {
        error("the variable of a #for loop must stay defined and a number, and be no parameter that "
              "stands for the caller's variable");
      }
      const double value = entry->value.number() + loop.step;
      entry->value.set_number(value);
      const bool over = (loop.step > 0 && value > loop.end + kEpsilon) ||
                        (loop.step < 0 && value < loop.end - kEpsilon);
      if (over) {
        conditionals.pop_back();
      } else {
        count_turn();
        seek(frames.back(), loop.start, loop.start_token);
      }
      return;
    }
  }
}

}  // namespace durer
