// Numeric expressions (spec/language.md 5): recursive descent that computes as it reads.
//
// `width` is the number of terms that the context expects; floats are replicated to it as soon as
// they are read. Operands are read with directives on, operators with the caller's setting.
#include <cmath>
#include <limits>

#include "parser/arithmetic.h"
#include "parser/parser_state.h"
#include "tracer/math/spline.h"
#include "tracer/scene/function.h"

namespace durer {
namespace {

// The narrower operand grows to the wider one; `right` may be promoted, too.
inline int common_width(Terms& left, Terms& right) {
  if (left.count < right.count) left.promote(right.count);
  else if (right.count < left.count) right.promote(left.count);
  return left.count;
}

}  // namespace

void Parser::State::parse_parameter(Terms& out, int width) {
  if (evaluate_compiled(out, width, ExpressionLevel::sum)) return;
  if (language_version < 150) {
    parse_factor(out, width);
  } else {
    parse_sum(out, width);
  }
}

void Parser::State::parse_sum(Terms& out, int width) {
  parse_term(out, width);
  for (;;) {
    const Token& token = peek();
    if (token.kind != TokenKind::symbol) return;
    const bool plus = token.symbol == Symbol::plus;
    if (!plus && token.symbol != Symbol::minus) return;
    consume();
    Terms right;
    parse_term(right, out.count);
    const int n = common_width(out, right);
    if (plus) {
      for (int i = 0; i < n; ++i) out.v[i] += right.v[i];
    } else {
      for (int i = 0; i < n; ++i) out.v[i] -= right.v[i];
    }
  }
}

void Parser::State::parse_term(Terms& out, int width) {
  parse_factor(out, width);
  for (;;) {
    const Token& token = peek();
    if (token.kind != TokenKind::symbol) return;
    const bool times = token.symbol == Symbol::star;
    if (!times && token.symbol != Symbol::slash) return;
    consume();
    Terms right;
    parse_factor(right, out.count);
    const int n = common_width(out, right);
    if (times) {
      for (int i = 0; i < n; ++i) out.v[i] *= right.v[i];
      continue;
    }
    for (int i = 0; i < n; ++i) {
      if (right.v[i] == 0.0) {
        message(Severity::warning, "division by zero");
        out.v[i] = std::numeric_limits<double>::infinity();
      } else {
        out.v[i] /= right.v[i];
      }
    }
  }
}

void Parser::State::parse_factor(Terms& out, int width) {
  const bool live_behind = directives_live;
  {
    const FlagScope on(directives_live, true);
    while (accept(Symbol::plus)) {
    }
    const Token& token = peek();
    if (token.kind == TokenKind::symbol) {
      if (token.symbol == Symbol::minus || token.symbol == Symbol::exclamation) {
        const bool negate = token.symbol == Symbol::minus;
        consume();
        const NestingScope deeper(*this);
        directives_live = live_behind;
        parse_factor(out, width);
        for (int i = 0; i < out.count; ++i) {
          out.v[i] = negate ? -out.v[i] : (is_true(out.v[i]) ? 0.0 : 1.0);
        }
        goto operand_complete;
      }
    }
    parse_primary(out, width);
  }
operand_complete:
  if (peek().is(Symbol::period)) parse_member(out);
}

void Parser::State::parse_member(Terms& out) {
  consume();
  int index = -1;
  const Token member = next();
  if (member.kind == TokenKind::keyword) {
    switch (member.keyword) {
      case Keyword::x: case Keyword::u: case Keyword::red: index = 0; break;
      case Keyword::y: case Keyword::v: case Keyword::green: index = 1; break;
      case Keyword::z: case Keyword::blue: index = 2; break;
      case Keyword::filter: case Keyword::t: index = 3; break;
      case Keyword::transmit: index = 4; break;
      case Keyword::gray: {
        const double blue = out.count > 2 ? out.v[2] : 0.0, green = out.count > 1 ? out.v[1] : 0.0;
        out.v[0] = 0.297 * out.v[0] + 0.589 * green + 0.114 * blue;
        out.count = 1;
        return;
      }
      default: break;
    }
  }
  if (index < 0) error("expected a component after '.', such as .x, .y, .red or .transmit");
  if (index >= out.count) {
    error("this value has " + std::to_string(out.count) +
          (out.count == 1 ? " component" : " components") + ", so '." +
          std::string(spelling(member.keyword)) + "' does not exist");
  }
  out.v[0] = out.v[index];
  out.count = 1;
}

void Parser::State::parse_primary(Terms& out, int width) {
  const Token& token = peek();
  switch (token.kind) {
    case TokenKind::number:
      out.set_float(token.number, width);
      consume();
      return;
    case TokenKind::identifier: {
      if (!look.value) {
        error_undeclared(token.name);
      }
      const Value& value = *look.value;
      switch (value.kind()) {
        case ValueKind::number:
          out.set_float(value.number(), width);
          consume();
          return;
        case ValueKind::uv:
        case ValueKind::vector4:
        case ValueKind::color:
        case ValueKind::vector: {
          out.count = value.terms();
          for (int i = 0; i < out.count; ++i) out.v[i] = value.numbers()[i];
          consume();
          // Three-term operands fill a wider context with zeros.
          if (out.count == 3) out.promote(width);
          return;
        }
        case ValueKind::function: {
          const std::shared_ptr<const FunctionNode> function = value.handle<FunctionNode>();
          consume();
          return call_function(out, *function, width);
        }
        case ValueKind::spline: {
          const std::shared_ptr<const Spline> spline = value.handle<Spline>();
          consume();
          return call_spline(out, *spline, width);
        }
        case ValueKind::unset:
          error(look.is_element
                    ? "this array element was never set"
                    : quoted(token.name) + " has no value yet");
        default:
          error_expected("a number, vector or colour");
      }
    }
    case TokenKind::symbol: {
      if (token.symbol == Symbol::paren_open) {
        consume();
        const NestingScope deeper(*this);
        parse_express(out, 1);
        out.promote(width);
        return expect(Symbol::paren_close);
      }
      if (token.symbol == Symbol::less) {
        consume();
        const NestingScope deeper(*this);
        int count = 0;
        do {
          out.v[count++] = parse_float();
          // A comma may follow each component but a fifth one.
          if (count < 5) accept_comma();
        } while (count < 5 && (count < 2 || !peek().is(Symbol::greater)));
        out.count = count;
        if (!accept(Symbol::greater)) error_expected("'>' at the end of the vector");
        return;
      }
      break;
    }
    case TokenKind::keyword: {
      const Keyword keyword = token.keyword;
      if (parse_builtin(keyword, out, width)) return;
      break;
    }
    default:
      break;
  }
  error_expected("a number, vector or colour");
}

void Parser::State::parse_relation(Terms& out, int width) {
  bool text_first;
  {
    const FlagScope on(directives_live, true);
    text_first = starts_string();
  }
  if (text_first) {
    const std::u16string left = parse_string();
    const Token comparison = peek();
    if (!is_comparison(comparison)) error_expected("a comparison of strings (<, <=, =, !=, >=, >)");
    consume();
    const std::u16string right = parse_string();
    const int order = left.compare(right);
    double result = 0;
    switch (comparison.symbol) {
      case Symbol::less: result = order < 0; break;
      case Symbol::less_equal: result = order <= 0; break;
      case Symbol::equal: result = order == 0; break;
      case Symbol::not_equal: result = order != 0; break;
      case Symbol::greater_equal: result = order >= 0; break;
      default: result = order > 0; break;
    }
    return out.set_float(result, width);
  }
  parse_sum(out, width);
  while (is_comparison(peek())) {
    const Symbol comparison = look.token.symbol;
    consume();
    Terms right;
    parse_sum(right, out.count);
    const int n = common_width(out, right);
    for (int i = 0; i < n; ++i) out.v[i] = holds(comparison, out.v[i], right.v[i]) ? 1.0 : 0.0;
  }
}

// & and | have the same precedence.
void Parser::State::parse_logical(Terms& out, int width) {
  parse_relation(out, width);
  for (;;) {
    const bool both = peek().is(Symbol::ampersand);
    if (!both && !look.token.is(Symbol::bar)) return;
    consume();
    Terms right;
    parse_relation(right, out.count);
    const int n = common_width(out, right);
    for (int i = 0; i < n; ++i) {
      const bool a = is_true(out.v[i]), b = is_true(right.v[i]);
      out.v[i] = (both ? a && b : a || b) ? 1.0 : 0.0;
    }
  }
}

void Parser::State::parse_express(Terms& out, int width) {
  if (evaluate_compiled(out, width, ExpressionLevel::express)) return;
  parse_logical(out, width);
  if (!peek().is(Symbol::question)) return;
  // A float that was replicated into the context is still one condition.
  if (out.count > width || (width == 1 && out.count != 1)) {
    error("the condition before '?' must be a float");
  }
  const double condition = out.v[0];
  consume();
  const NestingScope deeper(*this);
  Terms yes, no;
  parse_express(yes, width);
  expect(Symbol::colon);
  parse_express(no, width);
  out = is_true(condition) ? yes : no;
}

double Parser::State::parse_float() {
  Terms terms;
  parse_parameter(terms, 1);
  if (terms.count > 1) error("expected a float, found a vector or colour");
  return terms.v[0];
}

double Parser::State::parse_float_express() {
  Terms terms;
  parse_express(terms, 1);
  if (terms.count > 1) error("expected a float, found a vector or colour");
  return terms.v[0];
}

void Parser::State::finish_vector(Terms& terms, int width) {
  if (terms.count > width) {
    error(width == 2 ? "expected a vector of two components, found a longer one"
          : width == 3 ? "expected a vector of three components, found a longer one or a colour"
                       : "expected a vector of four components, found a colour");
  }
  // No promotion: `translate V.y` moves by <V.y, V.y, V.z> (floats are as wide as the context by now).
  terms.count = width;
}

Vec2 Parser::State::parse_uv() {
  Terms terms;
  parse_parameter(terms, 2);
  finish_vector(terms, 2);
  return {terms.v[0], terms.v[1]};
}

Vec3 Parser::State::parse_vector() {
  Terms terms;
  parse_parameter(terms, 3);
  finish_vector(terms, 3);
  return {terms.v[0], terms.v[1], terms.v[2]};
}

Vec4 Parser::State::parse_vec4() {
  Terms terms;
  parse_parameter(terms, 4);
  finish_vector(terms, 4);
  return {terms.v[0], terms.v[1], terms.v[2], terms.v[3]};
}

bool Parser::State::starts_expression() {
  const Token& token = peek();
  switch (token.kind) {
    case TokenKind::number:
      return true;
    case TokenKind::identifier:
      return look.value && (look.value->is_numeric() || look.value->kind() == ValueKind::function ||
                            look.value->kind() == ValueKind::spline);
    case TokenKind::symbol:
      return token.symbol == Symbol::less || token.symbol == Symbol::paren_open ||
             token.symbol == Symbol::plus || token.symbol == Symbol::minus ||
             token.symbol == Symbol::exclamation;
    case TokenKind::keyword:
      return is_builtin(token.keyword);
    default:
      return false;
  }
}

void Parser::State::call_spline(Terms& out, const Spline& spline, int width) {
  const NestingScope deeper(*this);
  if (!accept(Symbol::paren_open)) error_expected("'(' and the spline's parameter");
  const double parameter = parse_float();
  SplineInterpolation type = spline.kind;
  if (accept_comma()) {
    if (accept(Keyword::linear_spline)) {
      type = SplineInterpolation::linear;
    } else if (accept(Keyword::quadratic_spline)) {
      type = SplineInterpolation::quadratic;
    } else if (accept(Keyword::cubic_spline)) {
      type = SplineInterpolation::cubic;
    } else if (accept(Keyword::natural_spline)) {
      type = SplineInterpolation::natural;
    } else {
      error_expected("a type of spline, such as cubic_spline");
    }
  }
  expect(Symbol::paren_close);
  spline.evaluate(parameter, type, out.v);
  out.count = spline.terms();
  if (out.count == 3) out.promote(width);
}

}  // namespace durer
