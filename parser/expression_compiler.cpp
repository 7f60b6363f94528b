// From tokens to a CompiledExpression: the grammar of expression.cpp and builtins.cpp once more,
// for the part of it that means the same whenever it is read.
#include <algorithm>
#include <bit>
#include <cmath>

#include "parser/builtin_formulas.h"
#include "parser/parser_state.h"
#include "tracer/functions/compiled_function.h"
#include "tracer/scene/function.h"

namespace durer {
namespace {

using Operation = CompiledExpression::Operation;
using Step = CompiledExpression::Step;

constexpr size_t kMostRegisters = 4096;
constexpr int kMostArguments = 8;

// The registers of one value. A float in a wider context is the same register in each place.
struct Operand {
  int count = 1;
  int kept = 1;  // registers of the whole value that `.x` was selected from, else `count`
  std::array<uint16_t, 5> at{};

  void fill(uint16_t place, int width) {
    for (int i = 0; i < width; ++i) at[i] = place;
    count = kept = width;
  }
};

// Every function that returns bool gives false where the expression cannot be compiled.
class ExpressionCompiler {
 public:
  ExpressionCompiler(const Parser::State& state, const TokenPage& page, size_t first,
                     CompiledExpression& code)
      : state_(state),
        first_(page.tokens.data() + first),
        at_(first_),
        end_(page.tokens.data() + page.tokens.size()),
        code_(code) {}

  bool compile() {
    Operand result;
    const bool sum_level = code_.level == ExpressionLevel::sum;
    if (!(sum_level ? sum(result, code_.width) : express(result, code_.width))) return false;
    // What follows must be a token that nothing has to be executed for.
    const Token& behind = token();
    const bool plain = behind.kind == TokenKind::symbol ? behind.symbol != Symbol::hash
                                                        : behind.kind == TokenKind::keyword ||
                                                              behind.kind == TokenKind::number ||
                                                              behind.kind == TokenKind::string;
    if (!plain || registers_.size() > kMostRegisters) return false;
    code_.tokens = static_cast<uint32_t>(at_ - first_);
    code_.count = result.count;
    code_.kept = result.kept;
    code_.result = result.at;
    for (const Register& r : registers_) code_.registers.push_back(r.value);
    // Nothing but a variable and its subscripts.
    code_.is_identifier = first_->kind == TokenKind::identifier && first_operand_ends_ == at_;
    return true;
  }

 private:
  struct Register {
    double value = 0;
    bool constant = false;
  };

  const Token& token() const {
    static constexpr Token kNone{};
    return at_ < end_ ? *at_ : kNone;
  }
  bool accept(Symbol symbol) {
    if (!token().is(symbol)) return false;
    ++at_;
    return true;
  }

  uint16_t fresh(int count = 1) {
    const size_t first = registers_.size();
    registers_.resize(first + count);
    return static_cast<uint16_t>(first);
  }
  uint16_t constant(double value) {
    for (size_t i = 0; i < registers_.size(); ++i) {
      if (registers_[i].constant &&
          std::bit_cast<uint64_t>(registers_[i].value) == std::bit_cast<uint64_t>(value)) {
        return static_cast<uint16_t>(i);
      }
    }
    registers_.push_back({value, true});
    return static_cast<uint16_t>(registers_.size() - 1);
  }
  Step& emit(Operation operation, uint16_t a = 0, uint16_t b = 0, int results = 1) {
    Step& step = code_.steps.emplace_back();
    step.operation = operation;
    step.a = a;
    step.b = b;
    step.to = fresh(results);
    return step;
  }

  void promote(Operand& operand, int width) {
    if (width <= operand.count) return;
    const uint16_t filler = operand.count == 1 ? operand.at[0] : constant(0.0);
    for (int i = operand.count; i < width; ++i) operand.at[i] = filler;
    operand.count = width;
    operand.kept = std::max(operand.kept, width);
  }
  int common_width(Operand& left, Operand& right) {
    promote(left, right.count);
    promote(right, left.count);
    return left.count;
  }
  // The same step for each pair of registers, once for pairs that are the same.
  template <typename MakeStep>
  void for_each_term(Operand& left, const Operand& right, MakeStep make) {
    const Operand before = left;
    for (int i = 0; i < left.count; ++i) {
      const bool repeated =
          i > 0 && before.at[i] == before.at[i - 1] && right.at[i] == right.at[i - 1];
      left.at[i] = repeated ? left.at[i - 1] : make(before.at[i], right.at[i]);
    }
  }

  bool sum(Operand& out, int width) {
    if (!term(out, width)) return false;
    for (;;) {
      const bool plus = token().is(Symbol::plus);
      if (!plus && !token().is(Symbol::minus)) return true;
      ++at_;
      Operand right;
      if (!term(right, out.count)) return false;
      common_width(out, right);
      for_each_term(out, right, [&](uint16_t a, uint16_t b) {
        if (registers_[a].constant && registers_[b].constant) {
          const double x = registers_[a].value, y = registers_[b].value;
          return constant(plus ? x + y : x - y);
        }
        return emit(plus ? Operation::add : Operation::subtract, a, b).to;
      });
    }
  }

  bool term(Operand& out, int width) {
    if (!factor(out, width)) return false;
    for (;;) {
      const bool times = token().is(Symbol::star);
      if (!times && !token().is(Symbol::slash)) return true;
      ++at_;
      Operand right;
      if (!factor(right, out.count)) return false;
      common_width(out, right);
      for_each_term(out, right, [&](uint16_t a, uint16_t b) {
        const double x = registers_[a].value, y = registers_[b].value;
        if (registers_[a].constant && registers_[b].constant && (times || y != 0.0)) {
          return constant(times ? x * y : x / y);
        }
        return emit(times ? Operation::multiply : Operation::divide, a, b).to;
      });
    }
  }

  bool factor(Operand& out, int width) {
    if (++nesting_ > kCompiledNesting) return false;
    while (accept(Symbol::plus)) {
    }
    const bool negated = token().is(Symbol::minus);
    if (negated || token().is(Symbol::exclamation)) {
      ++at_;
      if (!factor(out, width)) return false;
      for_each_term(out, Operand(out), [&](uint16_t a, uint16_t) {
        if (negated && registers_[a].constant) return constant(-registers_[a].value);
        return emit(negated ? Operation::negate : Operation::not_, a).to;
      });
    } else if (!primary(out, width)) {
      return false;
    }
    if (token().is(Symbol::period) && !member(out)) return false;
    --nesting_;
    return true;
  }

  bool member(Operand& out) {
    ++at_;
    if (token().kind != TokenKind::keyword) return false;
    int index = -1;
    switch (token().keyword) {
      case Keyword::x: case Keyword::u: case Keyword::red: index = 0; break;
      case Keyword::y: case Keyword::v: case Keyword::green: index = 1; break;
      case Keyword::z: case Keyword::blue: index = 2; break;
      case Keyword::filter: case Keyword::t: index = 3; break;
      case Keyword::transmit: index = 4; break;
      default: return false;
    }
    if (index >= out.count) return false;
    ++at_;
    out.at[0] = out.at[index];
    out.count = 1;
    return true;
  }

  bool primary(Operand& out, int width) {
    const Token& first = token();
    switch (first.kind) {
      case TokenKind::number:
        ++at_;
        out.fill(constant(first.number), width);
        return true;
      case TokenKind::identifier:
        return identifier(out, width);
      case TokenKind::keyword:
        return builtin(first.keyword, out, width);
      case TokenKind::symbol:
        break;
      default:
        return false;
    }
    if (accept(Symbol::paren_open)) {
      if (!express(out, 1)) return false;
      promote(out, width);
      return accept(Symbol::paren_close);
    }
    if (!accept(Symbol::less)) return false;
    int count = 0;
    do {
      if (!float_at(ExpressionLevel::sum, out.at[count++])) return false;
      if (count < 5) accept(Symbol::comma);
    } while (count < 5 && (count < 2 || !token().is(Symbol::greater)));
    out.count = out.kept = count;
    return accept(Symbol::greater);
  }

  bool float_at(ExpressionLevel level, uint16_t& place) {
    Operand operand;
    if (!(level == ExpressionLevel::sum ? sum(operand, 1) : express(operand, 1))) return false;
    place = operand.at[0];
    return operand.count == 1;
  }
  bool vector_at(Operand& operand) {
    if (!sum(operand, 3) || operand.count > 3) return false;
    for (int i = operand.kept; i < 3; ++i) operand.at[i] = constant(0.0);
    return true;
  }

  bool identifier(Operand& out, int width) {
    const bool is_first = at_ == first_;
    const Name name = token().name;
    const Entry* entry = state_.symbols.find(name);
    if (!entry || entry->deprecation) return false;
    const Value* value = entry->alias ? Parser::State::target_of(*entry) : &entry->value;
    if (!value) return false;
    ++at_;
    ValueKind kind = value->kind();
    if (kind == ValueKind::function) {
      return call(*value->as<FunctionNode>().compiled, name, out, width);
    }
    uint16_t subscript = 0;
    const bool is_element = kind == ValueKind::array;
    if (is_element) {
      if (!subscripts(value->as<Array>().shape.dimensions, name, subscript)) return false;
      kind = value->as<Array>().element_kind;
    }
    if (kind == ValueKind::number) {
      Step& step = emit(is_element ? Operation::element_number : Operation::number, subscript);
      step.name = name;
      out.fill(step.to, width);
    } else if (kind > ValueKind::number && kind <= ValueKind::color) {
      const int count = static_cast<int>(kind);
      Step& step =
          emit(is_element ? Operation::element_vector : Operation::vector, subscript, 0, count);
      step.name = name;
      step.count = static_cast<uint8_t>(count);
      for (int i = 0; i < count; ++i) out.at[i] = static_cast<uint16_t>(step.to + i);
      out.count = out.kept = count;
      if (count == 3) promote(out, width);
    } else {
      return false;
    }
    if (is_first) first_operand_ends_ = at_;
    return true;
  }

  // `[i][j]...`, one for each dimension; `flat` becomes the place in the row-by-row list.
  bool subscripts(int dimensions, Name name, uint16_t& flat) {
    for (int d = 0; d < dimensions; ++d) {
      uint16_t subscript = 0;
      if (!accept(Symbol::bracket_open) || !float_at(ExpressionLevel::sum, subscript) ||
          !accept(Symbol::bracket_close)) {
        return false;
      }
      Step& step =
          emit(d == 0 ? Operation::first_subscript : Operation::next_subscript, subscript, flat);
      step.name = name;
      step.count = static_cast<uint8_t>(d == 0 ? dimensions : d);
      flat = step.to;
    }
    return !token().is(Symbol::bracket_open);
  }

  bool call(const CompiledFunction& function, Name name, Operand& out, int width) {
    const int count = function.parameter_count();
    if (function.is_vector() || count > kMostArguments || !accept(Symbol::paren_open)) return false;
    std::array<uint16_t, kMostArguments> arguments{};
    for (int i = 0; i < count; ++i) {
      if (i > 0) accept(Symbol::comma);
      if (!float_at(ExpressionLevel::sum, arguments[i])) return false;
    }
    if (!accept(Symbol::paren_close)) return false;
    Step& step = emit(Operation::call);
    step.list = keep(arguments.data(), count);
    step.count = static_cast<uint8_t>(count);
    step.name = name;
    out.fill(step.to, width);
    return true;
  }

  uint16_t keep(const uint16_t* operands, int count) {
    const size_t first = code_.operands.size();
    code_.operands.insert(code_.operands.end(), operands, operands + count);
    return static_cast<uint16_t>(first);
  }

  bool builtin(Keyword keyword, Operand& out, int width) {
    ++at_;
    const auto unit = [&](double x, double y, double z) {
      out.at[0] = constant(x), out.at[1] = constant(y), out.at[2] = constant(z);
      out.count = out.kept = 3;
      promote(out, width);
      return true;
    };
    const auto number = [&](double value) {
      out.fill(constant(value), width);
      return true;
    };
    const auto one = [&](Operation operation) {
      uint16_t argument = 0;
      if (!accept(Symbol::paren_open) || !float_at(ExpressionLevel::express, argument) ||
          !accept(Symbol::paren_close)) {
        return false;
      }
      out.fill(emit(operation, argument).to, width);
      return true;
    };
    const auto two = [&](Operation operation) {
      uint16_t first = 0, second = 0;
      if (!accept(Symbol::paren_open) || !float_at(ExpressionLevel::sum, first)) return false;
      accept(Symbol::comma);
      if (!float_at(ExpressionLevel::sum, second) || !accept(Symbol::paren_close)) return false;
      out.fill(emit(operation, first, second).to, width);
      return true;
    };
    const auto fold = [&](Operation operation) {
      uint16_t result = 0, next = 0;
      if (!accept(Symbol::paren_open) || !float_at(ExpressionLevel::sum, result)) return false;
      while (accept(Symbol::comma)) {
        if (!float_at(ExpressionLevel::sum, next)) return false;
        result = emit(operation, result, next).to;
      }
      out.fill(result, width);
      return accept(Symbol::paren_close);
    };
    switch (keyword) {
      case Keyword::x: return unit(1, 0, 0);
      case Keyword::y: return unit(0, 1, 0);
      case Keyword::z: return unit(0, 0, 1);
      case Keyword::u:
      case Keyword::v:
        out.at[0] = constant(keyword == Keyword::u ? 1 : 0);
        out.at[1] = constant(keyword == Keyword::u ? 0 : 1);
        out.count = out.kept = 2;
        return true;
      case Keyword::pi: return number(kPi);
      case Keyword::true_: case Keyword::yes: case Keyword::on: return number(1);
      case Keyword::false_: case Keyword::no: case Keyword::off: return number(0);
      case Keyword::clock: return number(static_cast<float>(state_.options.clock));

#define DURER_FUNCTION(name, formula) \
  case Keyword::name: return one(Operation::name);
      DURER_FLOAT_FUNCTIONS(DURER_FUNCTION)
#undef DURER_FUNCTION
      case Keyword::acos: return one(Operation::acos);
      case Keyword::asin: return one(Operation::asin);
      case Keyword::sqrt: return one(Operation::sqrt);
      case Keyword::ln: return one(Operation::ln);
      case Keyword::log: return one(Operation::log);
      case Keyword::rand: return ++randoms_ <= kCompiledRandoms && one(Operation::rand);

      case Keyword::atan2: return two(Operation::atan2);
      case Keyword::pow: return two(Operation::pow);
      case Keyword::mod: return two(Operation::mod);
      case Keyword::div: return two(Operation::div);
      case Keyword::min: return fold(Operation::min);
      case Keyword::max: return fold(Operation::max);
      case Keyword::select: return select(out, width);
      case Keyword::dimension_size: return dimension_size(out, width);

      case Keyword::vlength: return vectors(Operation::vlength, 1, 1, out, width);
      case Keyword::vdot: return vectors(Operation::vdot, 2, 1, out, width);
      case Keyword::vnormalize: return vectors(Operation::vnormalize, 1, 3, out, width);
      case Keyword::vcross: return vectors(Operation::vcross, 2, 3, out, width);
      case Keyword::vrotate: return vectors(Operation::vrotate, 2, 3, out, width);
      case Keyword::vaxis_rotate: return vectors(Operation::vaxis_rotate, 2, 3, out, width);
      default: return false;
    }
  }

  bool select(Operand& out, int width) {
    if (!accept(Symbol::paren_open)) return false;
    std::array<uint16_t, 4> arguments{};
    int count = 0;
    do {
      if (!float_at(ExpressionLevel::sum, arguments[count++])) return false;
      if (count < 4) accept(Symbol::comma);
    } while (count < 3 || (count < 4 && !token().is(Symbol::paren_close)));
    Step& step = emit(Operation::select);
    step.list = keep(arguments.data(), count);
    step.count = static_cast<uint8_t>(count);
    out.fill(step.to, width);
    return accept(Symbol::paren_close);
  }

  bool dimension_size(Operand& out, int width) {
    if (!accept(Symbol::paren_open) || token().kind != TokenKind::identifier) return false;
    const Name name = token().name;
    const Entry* entry = state_.symbols.find(name);
    if (!entry || entry->deprecation) return false;
    ++at_;
    if (token().is(Symbol::bracket_open)) return false;
    accept(Symbol::comma);
    uint16_t which = 0;
    if (!float_at(ExpressionLevel::sum, which) || !accept(Symbol::paren_close)) return false;
    Step& step = emit(Operation::dimension_size, which);
    step.name = name;
    out.fill(step.to, width);
    return true;
  }

  // Functions of one or two vectors; vaxis_rotate has an angle behind them.
  bool vectors(Operation operation, int given, int results, Operand& out, int width) {
    if (!accept(Symbol::paren_open)) return false;
    std::array<uint16_t, 7> arguments{};
    int count = 0;
    for (int i = 0; i < given; ++i) {
      if (i > 0) accept(Symbol::comma);
      Operand vector;
      if (!vector_at(vector)) return false;
      for (int axis = 0; axis < 3; ++axis) arguments[count++] = vector.at[axis];
    }
    if (operation == Operation::vaxis_rotate) {
      accept(Symbol::comma);
      if (!float_at(ExpressionLevel::sum, arguments[count++])) return false;
    }
    if (!accept(Symbol::paren_close)) return false;
    Step& step = emit(operation, 0, 0, results);
    step.list = keep(arguments.data(), count);
    if (results == 1) {
      out.fill(step.to, width);
      return true;
    }
    for (int axis = 0; axis < 3; ++axis) out.at[axis] = static_cast<uint16_t>(step.to + axis);
    out.count = out.kept = 3;
    promote(out, width);
    return true;
  }

  bool relation(Operand& out, int width) {
    if (!sum(out, width)) return false;
    while (is_comparison(token())) {
      const Symbol comparison = token().symbol;
      ++at_;
      Operand right;
      if (!sum(right, out.count)) return false;
      common_width(out, right);
      for_each_term(out, right, [&](uint16_t a, uint16_t b) {
        Step& step = emit(Operation::compare, a, b);
        step.count = static_cast<uint8_t>(comparison);
        return step.to;
      });
    }
    return true;
  }

  bool logical(Operand& out, int width) {
    if (!relation(out, width)) return false;
    for (;;) {
      const bool both = token().is(Symbol::ampersand);
      if (!both && !token().is(Symbol::bar)) return true;
      ++at_;
      Operand right;
      if (!relation(right, out.count)) return false;
      common_width(out, right);
      for_each_term(out, right, [&](uint16_t a, uint16_t b) {
        return emit(both ? Operation::both : Operation::either, a, b).to;
      });
    }
  }

  bool express(Operand& out, int width) {
    if (++nesting_ > kCompiledNesting) return false;
    if (!logical(out, width)) return false;
    --nesting_;
    if (!token().is(Symbol::question)) return true;
    if (out.count > width || (width == 1 && out.count != 1)) return false;
    const uint16_t condition = out.at[0];
    ++at_;
    if (++nesting_ > kCompiledNesting) return false;
    Operand no;
    if (!express(out, width) || !accept(Symbol::colon) || !express(no, width)) return false;
    if (out.count != no.count || out.kept != out.count || no.kept != no.count) return false;
    for_each_term(out, no, [&](uint16_t a, uint16_t b) {
      Step& step = emit(Operation::choose, a, b);
      step.name = condition;
      return step.to;
    });
    --nesting_;
    return true;
  }

  const Parser::State& state_;
  const Token* first_;
  const Token* at_;
  const Token* end_;
  CompiledExpression& code_;
  std::vector<Register> registers_;
  const Token* first_operand_ends_ = nullptr;
  int nesting_ = 0;
  int randoms_ = 0;
};

}  // namespace

std::unique_ptr<CompiledExpression> Parser::State::compile_expression(const TokenPage& page,
                                                                      size_t first, int width,
                                                                      ExpressionLevel level) const {
  auto code = std::make_unique<CompiledExpression>();
  code->width = width;
  code->level = level;
  if (!ExpressionCompiler(*this, page, first, *code).compile()) return nullptr;
  return code;
}

}  // namespace durer
