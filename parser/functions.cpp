// function{ } (spec/functions.md 1, 2): the grammar of its body, built into a tape while it is read.
#include <cmath>

#include "parser/live_fields.h"
#include "parser/parser_state.h"
#include "parser/statements/statements.h"
#include "tracer/functions/tape.h"
#include "tracer/math/spline.h"
#include "tracer/scene/function.h"

namespace durer {
namespace {

constexpr size_t kMostParameters = 56;
constexpr size_t kMostLoopNames = 56;
constexpr double kPi = 3.14159265358979323846;

// x and u, y and v, z: three variables (spec/functions.md 1.2); -1: no such word.
int special_variable(Keyword keyword) {
  switch (keyword) {
    case Keyword::x: case Keyword::u: return 0;
    case Keyword::y: case Keyword::v: return 1;
    case Keyword::z: return 2;
    default: return -1;
  }
}

bool float_function(Keyword keyword, FloatFunction& function) {
  switch (keyword) {
    case Keyword::sin: function = FloatFunction::sin_; return true;
    case Keyword::cos: function = FloatFunction::cos_; return true;
    case Keyword::tan: function = FloatFunction::tan_; return true;
    case Keyword::asin: function = FloatFunction::asin_; return true;
    case Keyword::acos: function = FloatFunction::acos_; return true;
    case Keyword::atan: function = FloatFunction::atan_; return true;
    case Keyword::sinh: function = FloatFunction::sinh_; return true;
    case Keyword::cosh: function = FloatFunction::cosh_; return true;
    case Keyword::tanh: function = FloatFunction::tanh_; return true;
    case Keyword::asinh: function = FloatFunction::asinh_; return true;
    case Keyword::acosh: function = FloatFunction::acosh_; return true;
    case Keyword::atanh: function = FloatFunction::atanh_; return true;
    case Keyword::exp: function = FloatFunction::exp_; return true;
    case Keyword::sqrt: function = FloatFunction::sqrt_; return true;
    case Keyword::floor: function = FloatFunction::floor_; return true;
    case Keyword::ceil: function = FloatFunction::ceil_; return true;
    case Keyword::ln: function = FloatFunction::ln; return true;
    case Keyword::log: function = FloatFunction::log; return true;
    case Keyword::abs: function = FloatFunction::abs; return true;
    case Keyword::int_: function = FloatFunction::int_; return true;
    case Keyword::radians: function = FloatFunction::radians; return true;
    case Keyword::degrees: function = FloatFunction::degrees; return true;
    case Keyword::atan2: function = FloatFunction::atan2_; return true;
    case Keyword::mod: function = FloatFunction::mod; return true;
    case Keyword::div: function = FloatFunction::div; return true;
    case Keyword::pow: function = FloatFunction::pow_; return true;
    case Keyword::min: function = FloatFunction::min; return true;
    case Keyword::max: function = FloatFunction::max; return true;
    case Keyword::select: function = FloatFunction::select; return true;
    default: return false;
  }
}

// Reads one expression and builds its tape.
class FunctionBody {
 public:
  using Term = TapeBuilder::Term;
  using Parameter = Parser::State::FunctionParameter;

  FunctionBody(Parser::State& state, const std::vector<Parameter>& parameters, Name self)
      : state_(state),
        parameters_(parameters),
        self_(self),
        builder_(static_cast<int>(parameters.size())) {
    // Later parameters win for x/u, y/v and z.
    for (size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].special >= 0) special_[parameters[i].special] = static_cast<int>(i);
    }
  }

  FunctionHandle parse() {
    const Term body = expression();
    FunctionHandle function = builder_.finish(body);
    if (builder_.folded_zero_power()) {
      state_.message(Severity::warning, "a power of zero was replaced by 1");
    }
    return function;
  }

 private:
  // Binary operators, loosest first: | & comparisons + * (spec/functions.md 2.1).
  static bool operator_at(const Token& token, int level, BinaryOperator& op) {
    if (token.kind != TokenKind::symbol) return false;
    switch (token.symbol) {
      case Symbol::bar: op = BinaryOperator::logical_or; return level == 0;
      case Symbol::ampersand: op = BinaryOperator::logical_and; return level == 1;
      case Symbol::equal: op = BinaryOperator::equal; return level == 2;
      case Symbol::not_equal: op = BinaryOperator::not_equal; return level == 2;
      case Symbol::less: op = BinaryOperator::less; return level == 2;
      case Symbol::less_equal: op = BinaryOperator::less_equal; return level == 2;
      case Symbol::greater: op = BinaryOperator::greater; return level == 2;
      case Symbol::greater_equal: op = BinaryOperator::greater_equal; return level == 2;
      case Symbol::plus: op = BinaryOperator::add; return level == 3;
      case Symbol::minus: op = BinaryOperator::subtract; return level == 3;
      case Symbol::star: op = BinaryOperator::multiply; return level == 4;
      case Symbol::slash: op = BinaryOperator::divide; return level == 4;
      default: return false;
    }
  }

  Term expression() {
    const NestingScope deeper(state_);
    const Term result = binary(0);
    const Token& token = state_.peek();
    if (!token.is(Symbol::paren_close) && !token.is(Symbol::brace_close) && !token.is(Symbol::comma)) {
      state_.error_expected("an operator, or the end of the function");
    }
    return result;
  }

  Term binary(int level) {
    if (level == 5) return signed_operand();
    Term left = binary(level + 1);
    BinaryOperator op;
    while (operator_at(state_.peek(), level, op)) {
      state_.consume();
      const Term right = binary(level + 1);
      left = builder_.binary(op, left, right);
    }
    return left;
  }

  Term signed_operand() {
    if (state_.accept(Symbol::minus)) return builder_.negate(operand());
    state_.accept(Symbol::plus);
    return operand();
  }

  Term operand() {
    const Token token = state_.peek();
    switch (token.kind) {
      case TokenKind::number:
        state_.consume();
        return builder_.constant(token.number);
      case TokenKind::symbol:
        if (token.symbol == Symbol::paren_open) {
          state_.consume();
          const Term inside = expression();
          state_.expect(Symbol::paren_close);
          return builder_.parenthesized(inside);
        }
        break;
      case TokenKind::identifier:
        return identifier(token);
      case TokenKind::keyword:
        return word(token);
      default:
        break;
    }
    state_.error_expected("an operand of the function");
  }

  Term identifier(const Token& token) {
    const Value* value = state_.look.value;
    if (value && value->kind() == ValueKind::number) {
      const double number = value->number();
      state_.consume();
      return builder_.constant(number);
    }
    if (value && value->kind() == ValueKind::function) {
      const std::shared_ptr<const FunctionNode> function = value->handle<FunctionNode>();
      state_.consume();
      state_.function_levels =
          std::max(state_.function_levels, state_.nesting.levels(function->compiled));
      return call(function->compiled);
    }
    if (value) state_.error_expected("an operand of the function (a float or a function)");
    // Loop names hide parameters, the latest first.
    for (size_t i = loops_.size(); i-- > 0;) {
      if (loops_[i].first != token.name) continue;
      state_.consume();
      return builder_.loop_variable(loops_[i].second);
    }
    for (size_t i = 0; i < parameters_.size(); ++i) {
      if (parameters_[i].special >= 0 || parameters_[i].name != token.name) continue;
      state_.consume();
      return builder_.parameter(static_cast<int>(i));
    }
    if (token.name == self_ && self_ != 0) {
      state_.consume();
      state_.message(Severity::possible_error, "this function calls itself");
      return builder_.call_self(arguments());
    }
    state_.error(state_.quoted(token.name) + " is neither a parameter of this function nor a declared float or function",
                 state_.suggestion(token.name));
  }

  Term word(const Token& token) {
    const int special = special_variable(token.keyword);
    if (special >= 0) {
      state_.consume();
      return builder_.parameter(special_[special]);
    }
    if (token.keyword == Keyword::pi) {
      state_.consume();
      return builder_.constant(kPi);
    }
    if (token.keyword == Keyword::clock) {
      state_.consume();
      return builder_.constant(static_cast<float>(state_.options.clock));
    }
    if (token.keyword == Keyword::sum || token.keyword == Keyword::prod) return loop(token.keyword);
    FloatFunction function;
    if (!float_function(token.keyword, function)) {
      state_.error_expected("an operand of the function");
    }
    state_.consume();
    return builder_.call(function, arguments());
  }

  std::vector<Term> arguments() {
    std::vector<Term> result;
    if (!state_.accept(Symbol::paren_open)) state_.error_expected("'(' and the function's arguments");
    if (state_.accept(Symbol::paren_close)) return result;
    result.push_back(expression());
    while (state_.accept_comma()) result.push_back(expression());
    state_.expect(Symbol::paren_close);
    return result;
  }

  Term call(const FunctionHandle& function) {
    std::vector<Term> terms = arguments();
    if (!function->is_vector()) return builder_.call(function, std::move(terms));
    if (!state_.accept(Symbol::period)) {
      state_.error_expected("'.' and a component: this function's result is a vector");
    }
    const Token member = state_.next();
    FunctionMember which = FunctionMember::first;
    switch (member.kind == TokenKind::keyword ? member.keyword : Keyword::all) {
      case Keyword::x: case Keyword::u: case Keyword::red: which = FunctionMember::first; break;
      case Keyword::y: case Keyword::v: case Keyword::green: which = FunctionMember::second; break;
      case Keyword::z: case Keyword::blue: which = FunctionMember::third; break;
      case Keyword::t: case Keyword::filter: which = FunctionMember::fourth; break;
      case Keyword::transmit: which = FunctionMember::fifth; break;
      case Keyword::gray: which = FunctionMember::grey; break;
      default:
        if (member.kind == TokenKind::identifier && state_.names.text(member.name) == "hf") {
          state_.parser.note_experimental("function '.hf'");
          which = FunctionMember::height;
          break;
        }
        // A keyword nowhere else (measured on povray 3.7).
        if (member.kind == TokenKind::identifier && state_.names.text(member.name) == "grey") {
          which = FunctionMember::grey;
          break;
        }
        state_.error("expected a component after '.', such as .x, .red or .gray");
    }
    return builder_.call(function, std::move(terms), which);
  }

  // sum(name, from, to, term), prod(...)
  Term loop(Keyword keyword) {
    state_.consume();
    state_.expect(Symbol::paren_open);
    const Token name = state_.peek();
    const bool special = name.kind == TokenKind::keyword && special_variable(name.keyword) >= 0;
    if (!special && (name.kind != TokenKind::identifier || state_.look.value)) {
      state_.error_expected("a new name for the loop's variable");
    }
    if (loops_.size() == kMostLoopNames) state_.error("too many nested sums and products");
    state_.consume();
    state_.accept_comma();
    const int id = builder_.begin_loop();
    // x y z u v always mean the function's own.
    loops_.emplace_back(special ? Name{0} : name.name, id);
    const Term from = expression();
    state_.expect(Symbol::comma);
    const Term to = expression();
    state_.expect(Symbol::comma);
    const Term term = expression();
    state_.expect(Symbol::paren_close);
    loops_.pop_back();
    return builder_.end_loop(id, keyword == Keyword::prod, from, to, term);
  }

  Parser::State& state_;
  const std::vector<Parameter>& parameters_;
  Name self_;
  TapeBuilder builder_;
  int special_[3] = {-1, -1, -1};
  std::vector<std::pair<Name, int>> loops_;
};

}  // namespace

std::vector<Parser::State::FunctionParameter> Parser::State::parse_function_parameters() {
  std::vector<FunctionParameter> parameters;
  bool another = true;
  while (another) {
    const Token token = peek();
    FunctionParameter parameter;
    if (token.kind == TokenKind::keyword && special_variable(token.keyword) >= 0) {
      parameter.special = special_variable(token.keyword);
    } else if (token.kind == TokenKind::identifier && !look.value) {
      parameter.name = token.name;
    } else {
      error_expected("a name for a parameter that is not declared otherwise");
    }
    if (parameters.size() == kMostParameters) error("a function has at most 56 parameters");
    parameters.push_back(parameter);
    consume();
    another = accept_comma() || !peek().is(Symbol::paren_close);
  }
  consume();
  return parameters;
}

FunctionHandle Parser::State::parse_function_body(const std::vector<FunctionParameter>& parameters) {
  const Token first = peek();
  if (first.kind == TokenKind::string) {
    parse_string();
  } else if (first.kind == TokenKind::keyword) {
    switch (first.keyword) {
      case Keyword::internal: {
        consume();
        expect(Symbol::paren_open);
        if (peek().kind != TokenKind::number) error_expected("the number of an internal function");
        const double number = look.token.number;
        consume();
        expect(Symbol::paren_close);
        FunctionHandle function =
            number < 1000 ? make_internal_function(static_cast<int>(number), field_settings) : nullptr;
        if (!function) error("there is no internal function of this number");
        return function;
      }
      case Keyword::pattern: {
        consume();
        auto pattern = parse_function_pattern(parser);
        function_levels = check_nesting(1 + nesting.levels(*pattern));
        return make_pattern_function(make_live_pattern(std::move(pattern), field_settings,
                                                       scene.settings, parser.effective_version()));
      }
      case Keyword::pigment: {
        consume();
        auto pigment = parse_function_pigment(parser);
        function_levels = check_nesting(1 + nesting.levels(pigment));
        return make_pigment_function(make_live_pigment(std::move(pigment), field_settings,
                                                       scene.settings, parser.effective_version()));
      }
      case Keyword::transform:
        consume();
        return make_transform_function(parse_transform_block(parser));
      case Keyword::spline:
        consume();
        return make_spline_function(parse_spline());
      default:
        break;
    }
  }
  try {
    return FunctionBody(*this, parameters, declaring).parse();
  } catch (const FunctionError& wrong) {
    error(wrong.what());
  }
}

std::shared_ptr<const FunctionNode> Parser::State::parse_function(FunctionParameters defaults,
                                                                  FunctionBodies bodies) {
  auto node = std::make_shared<FunctionNode>();
  node->position = position();
  std::vector<FunctionParameter> parameters;
  const bool named = accept(Symbol::paren_open);
  if (named) {
    parameters = parse_function_parameters();
  } else {
    const int count = defaults == FunctionParameters::xyz ? 3 : 2;
    for (int i = 0; i < count; ++i) parameters.push_back({0, i});
  }
  if (!accept(Symbol::brace_open)) error_expected("'{' after 'function'");
  if (bodies == FunctionBodies::expressions &&
      parser.at_any({Keyword::pattern, Keyword::pigment, Keyword::transform, Keyword::spline})) {
    error_expected("an operand");
  }
  if (named && parser.at_any({Keyword::pattern, Keyword::pigment, Keyword::transform, Keyword::spline})) {
    error("a function of this kind has its own parameters: it takes no list of names");
  }
  const int outer_levels = function_levels;
  function_levels = 0;
  node->compiled = parse_function_body(parameters);
  nesting.note(node->compiled, function_levels);
  function_levels = outer_levels;
  if (!accept(Symbol::brace_close)) error_expected("'}' at the end of the function");
  return node;
}

// f(a, b, ...) in an expression of the scene: exactly its number of floats.
void Parser::State::call_function(Terms& out, const FunctionNode& function, int width) {
  const NestingScope deeper(*this);
  const CompiledFunction& compiled = *function.compiled;
  if (!accept(Symbol::paren_open)) error_expected("'(' and the function's arguments");
  const int count = compiled.parameter_count();
  double arguments[kMostParameters + 8] = {};
  for (int i = 0; i < count; ++i) {
    if (i > 0) accept_comma();
    if (peek().is(Symbol::paren_close)) {
      error("this function takes " + std::to_string(count) + " arguments, only " +
            std::to_string(i) + " given");
    }
    arguments[i] = parse_float();
  }
  if (!accept(Symbol::paren_close)) {
    error_expected("')': the function takes " + std::to_string(count) +
                   (count == 1 ? " argument" : " arguments"));
  }
  try {
    if (compiled.is_vector()) {
      compiled.evaluate(arguments, out.v);
      out.count = compiled.result_width();
      if (out.count == 3) out.promote(width);
    } else {
      out.set_float(compiled.scalar(arguments), width);
    }
  } catch (const FunctionRecursionError& deep) {
    error(deep.what());
  }
}

}  // namespace durer
