// Runs compiled expressions and moves the stream behind them.
#include <cmath>

#include "parser/builtin_formulas.h"
#include "parser/parser_state.h"
#include "tracer/functions/compiled_function.h"
#include "tracer/scene/function.h"

namespace durer {
namespace {

using Operation = CompiledExpression::Operation;
using Step = CompiledExpression::Step;

// Reading starts in a page at least so often, and an expression is read so often, before it is
// worth while to compile.
constexpr uint32_t kReturnsBeforeCaching = 3;
constexpr int kVisitsBeforeCompiling = 2;
// Variables that change their kind make an expression miss: it is compiled anew, a few times.
constexpr int kMostMisses = 4;
constexpr int kMostAttempts = 8;

// What rand() gave is taken back if the expression has to be read in the ordinary way after all.
class RandomUndo {
 public:
  explicit RandomUndo(std::vector<uint32_t>& streams) : streams_(streams) {}
  void note(size_t index) { noted_[count_++] = {index, streams_[index]}; }
  void roll_back() {
    while (count_ > 0) {
      --count_;
      streams_[noted_[count_].index] = noted_[count_].state;
    }
  }

 private:
  struct Noted {
    size_t index;
    uint32_t state;
  };
  std::vector<uint32_t>& streams_;
  std::array<Noted, kCompiledRandoms> noted_;
  int count_ = 0;
};

}  // namespace

const Value* Parser::State::plain_element(const Step& step, const double* r, ValueKind kind) const {
  const Value* value = plain_value(step.name);
  if (!value || value->kind() != ValueKind::array) return nullptr;
  const Array& array = value->as<Array>();
  const size_t index = static_cast<size_t>(r[step.a]);
  if (index >= array.elements.size()) return nullptr;
  const Value* element = &array.elements[index];
  return element->kind() == kind ? element : nullptr;
}

bool Parser::State::run(CompiledExpression& code) {
  RandomUndo undo(random_streams);
  double* const r = code.registers.data();
  const auto miss = [&] {
    undo.roll_back();
    return false;
  };
  const auto operand = [&](const Step& step, int i) {
    return r[code.operands[static_cast<size_t>(step.list + i)]];
  };
  const auto vector = [&](const Step& step, int first) {
    return Vec3(operand(step, first), operand(step, first + 1), operand(step, first + 2));
  };
  const auto put = [&](const Step& step, const Vec3& v) {
    r[step.to] = v.x, r[step.to + 1] = v.y, r[step.to + 2] = v.z;
  };
  for (const Step& step : code.steps) {
    double& to = r[step.to];
    const double a = r[step.a], b = r[step.b];
    switch (step.operation) {
      case Operation::number: {
        const Value* value = plain_value(step.name);
        if (!value || value->kind() != ValueKind::number) return miss();
        to = value->number();
        break;
      }
      case Operation::vector: {
        const Value* value = plain_value(step.name);
        if (!value || value->kind() != static_cast<ValueKind>(step.count)) return miss();
        for (int i = 0; i < step.count; ++i) r[step.to + i] = value->numbers()[i];
        break;
      }
      case Operation::element_number: {
        const Value* value = plain_element(step, r, ValueKind::number);
        if (!value) return miss();
        to = value->number();
        break;
      }
      case Operation::element_vector: {
        const Value* value = plain_element(step, r, static_cast<ValueKind>(step.count));
        if (!value) return miss();
        for (int i = 0; i < step.count; ++i) r[step.to + i] = value->numbers()[i];
        break;
      }
      case Operation::first_subscript:
      case Operation::next_subscript: {
        const bool first = step.operation == Operation::first_subscript;
        const Value* value = plain_value(step.name);
        if (!value || value->kind() != ValueKind::array) return miss();
        const ArrayShape& shape = value->as<Array>().shape;
        if (first && shape.dimensions != step.count) return miss();
        const double size = static_cast<double>(shape.sizes[first ? 0 : step.count]);
        const double whole = std::trunc(a + kEqualityTolerance);
        if (a < -kEqualityTolerance || !(whole < size)) return miss();
        to = first ? whole : b * size + whole;
        break;
      }
      case Operation::dimension_size: {
        const Value* value = plain_value(step.name);
        if (!value || value->kind() != ValueKind::array) return miss();
        const ArrayShape& shape = value->as<Array>().shape;
        to = builtin::dimension_size(shape, a);
        break;
      }

      case Operation::add: to = a + b; break;
      case Operation::subtract: to = a - b; break;
      case Operation::multiply: to = a * b; break;
      case Operation::divide:
        if (b == 0.0) return miss();
        to = a / b;
        break;
      case Operation::negate: to = -a; break;
      case Operation::not_: to = is_true(a) ? 0.0 : 1.0; break;
      case Operation::compare: to = holds(static_cast<Symbol>(step.count), a, b) ? 1.0 : 0.0; break;
      case Operation::both: to = is_true(a) && is_true(b) ? 1.0 : 0.0; break;
      case Operation::either: to = is_true(a) || is_true(b) ? 1.0 : 0.0; break;
      case Operation::choose: to = is_true(r[step.name]) ? a : b; break;

#define DURER_FUNCTION(name, formula) \
  case Operation::name: {             \
    const double p = a;               \
    to = formula;                     \
    break;                            \
  }
      DURER_FLOAT_FUNCTIONS(DURER_FUNCTION)
#undef DURER_FUNCTION
#define DURER_FUNCTION(name, formula) \
  case Operation::name: {             \
    const double p = a, q = b;        \
    to = formula;                     \
    break;                            \
  }
      DURER_FLOAT_PAIR_FUNCTIONS(DURER_FUNCTION)
      DURER_FLOAT_FOLDS(DURER_FUNCTION)
#undef DURER_FUNCTION
      case Operation::acos:
      case Operation::asin:
        if (!builtin::has_arc(a)) return miss();
        to = step.operation == Operation::acos ? std::acos(a) : std::asin(a);
        break;
      case Operation::sqrt:
        if (!builtin::has_root(a)) return miss();
        to = std::sqrt(a);
        break;
      case Operation::ln:
      case Operation::log:
        if (!builtin::has_logarithm(a)) return miss();
        to = step.operation == Operation::ln ? std::log(a) : std::log10(a);
        break;
      case Operation::rand: {
        const int32_t stream = to_int(a);
        if (stream < 0 || static_cast<size_t>(stream) >= random_streams.size()) return miss();
        undo.note(static_cast<size_t>(stream));
        to = next_random(a);
        break;
      }
      case Operation::atan2:
        if (!builtin::has_direction(a, b)) return miss();
        to = std::atan2(a, b);
        break;
      case Operation::pow:
        if (!builtin::has_power(a, b)) return miss();
        to = std::pow(a, b);
        break;
      case Operation::select:
        to = operand(step, builtin::selected(operand(step, 0), step.count));
        break;

      case Operation::vdot: to = dot(vector(step, 0), vector(step, 3)); break;
      case Operation::vlength: to = builtin::vlength(vector(step, 0)); break;
      case Operation::vcross: put(step, cross(vector(step, 0), vector(step, 3))); break;
      case Operation::vnormalize: {
        const Vec3 v = vector(step, 0);
        if (v == Vec3(0)) return miss();
        put(step, builtin::vnormalize(v));
        break;
      }
      case Operation::vrotate:
        put(step, builtin::vrotate(vector(step, 0), vector(step, 3)));
        break;
      case Operation::vaxis_rotate:
        put(step, builtin::vaxis_rotate(vector(step, 0), vector(step, 3), operand(step, 6)));
        break;
      case Operation::call: {
        const Value* value = plain_value(step.name);
        if (!value || value->kind() != ValueKind::function) return miss();
        const CompiledFunction& function = *value->as<FunctionNode>().compiled;
        if (function.is_vector() || function.parameter_count() != step.count) return miss();
        std::array<double, 8> arguments{};
        for (int i = 0; i < step.count; ++i) arguments[static_cast<size_t>(i)] = operand(step, i);
        try {
          to = function.scalar(arguments.data());
        } catch (const FunctionRecursionError&) {
          return miss();
        }
        break;
      }
    }
  }
  return true;
}

// The token that comes next, where it stands in its page; null if more has been read already than
// this one, or if it is the first of the page to come.
const Token* Parser::State::next_raw() const {
  const Frame& frame = frames.back();
  if (ahead == kNothing) return frame.at == frame.page_end ? nullptr : frame.at;
  // Elements have been read with their subscripts.
  if (ahead == kDeferred || (look.is_element && look.token.kind == TokenKind::identifier) ||
      frame.at == frame.page->tokens.data()) {
    return nullptr;
  }
  const Token* token = frame.at - 1;
  return token->offset == look.token.offset && last_file == frame.file.get() ? token : nullptr;
}

CompiledExpression* Parser::State::compiled_at(const Token*& first, int width,
                                               ExpressionLevel level) {
  TokenPage& page = *frames.back().page;
  if (page.returns < kReturnsBeforeCaching || !resolve_elements || waiting_switches > 0 ||
      language_version < 150) {
    return nullptr;
  }
  first = next_raw();
  if (!first) return nullptr;
  if (!page.expressions) {
    page.expressions = std::make_unique<ExpressionCache>();
    page.expressions->places.resize(page.tokens.size());
  }
  ExpressionCache& cache = *page.expressions;
  const size_t index = static_cast<size_t>(first - page.tokens.data());
  ExpressionCache::Place& place = cache.places[index];
  if (!place.expression) {
    if (place.attempts >= kMostAttempts || ++place.visits < kVisitsBeforeCompiling) return nullptr;
    place.visits = 0;
    ++place.attempts;
    std::unique_ptr<CompiledExpression> code = compile_expression(page, index, width, level);
    if (!code) return nullptr;
    cache.expressions.push_back(std::move(code));
    place.expression = static_cast<uint16_t>(cache.expressions.size());
  }
  CompiledExpression& code = *cache.expressions[place.expression - 1u];
  if (code.width != width || code.level != level ||
      depth + kCompiledNesting > options.limits.max_expression_depth) {
    return nullptr;
  }
  return &code;
}

// Leaves the stream as reading the tokens would: the one behind the expression has been looked at.
void Parser::State::pass_tokens(const Token* first, uint32_t count) {
  Frame& frame = frames.back();
  const Token& behind = first[count];
  frame.at = &behind + 1;
  look.token = behind;
  look.entry = nullptr;
  look.value = nullptr;
  ahead = kToken;
  consumed += count;
  last_offset = behind.offset;
  last_file = frame.file.get();
  behind_last = false;
}

bool Parser::State::evaluate_compiled(Terms& out, int width, ExpressionLevel level, Alone alone) {
  const Token* first = nullptr;
  CompiledExpression* const code = compiled_at(first, width, level);
  if (!code || (alone == Alone::reference && code->is_identifier)) return false;
  if (!run(*code)) {
    if (++code->misses == kMostMisses) {
      // For the kinds that its variables have now; the old code stays where it is, unused.
      ExpressionCache& cache = *frames.back().page->expressions;
      ExpressionCache::Place& place = cache.places[static_cast<size_t>(
          first - frames.back().page->tokens.data())];
      cache.expressions[place.expression - 1u].reset();
      place.expression = 0;
    }
    return false;
  }
  code->misses = 0;
  out.count = code->count;
  for (int i = 0; i < code->kept; ++i) {
    out.v[i] = code->registers[code->result[static_cast<size_t>(i)]];
  }
  pass_tokens(first, code->tokens);
  return true;
}

}  // namespace durer
