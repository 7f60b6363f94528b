#include "tracer/functions/tape.h"

#include <string>

#include "tracer/functions/expression_tree.h"
#include "tracer/functions/internal_function.h"

namespace durer {

namespace {

using Term = TapeBuilder::Term;

using NodeKind = ExpressionKind;

// The levels of spec/functions.md 2.1 from | to * /.
int level_of(BinaryOperator op) {
  switch (op) {
    case BinaryOperator::logical_or: return 1;
    case BinaryOperator::logical_and: return 2;
    case BinaryOperator::add:
    case BinaryOperator::subtract: return 4;
    case BinaryOperator::multiply:
    case BinaryOperator::divide: return 5;
    default: return 3;
  }
}

double apply(BinaryOperator op, double a, double b) {
  switch (op) {
    case BinaryOperator::logical_or: return a != 0 || b != 0;
    case BinaryOperator::logical_and: return a != 0 && b != 0;
    case BinaryOperator::equal: return a == b;
    case BinaryOperator::not_equal: return a != b;
    case BinaryOperator::less: return a < b;
    case BinaryOperator::less_equal: return a <= b;
    case BinaryOperator::greater: return !(a <= b);
    case BinaryOperator::greater_equal: return !(a < b);
    case BinaryOperator::add: return a + b;
    case BinaryOperator::subtract: return a - b;
    case BinaryOperator::multiply: return a * b;
    case BinaryOperator::divide: return a / b;
  }
  return 0;
}

}  // namespace

Term TapeBuilder::Expression::fold(Term t, bool folding) {
  switch (node(t).kind) {
    case NodeKind::constant:
    case NodeKind::parameter:
    case NodeKind::loop_variable:
    case NodeKind::sequence: return t;
    case NodeKind::negate: {
      const Term operand = fold(node(t).children[0], folding);
      node(t).children[0] = operand;
      if (folding && is_constant(operand)) {
        Node number{NodeKind::constant};
        number.value = -node(operand).value;
        return add(std::move(number));
      }
      return t;
    }
    case NodeKind::binary: return fold_sequence(t, folding);
    case NodeKind::float_call: fold_float_call(t, folding); return t;
    case NodeKind::parenthesized:
    case NodeKind::function_call:
    case NodeKind::self_call:
    case NodeKind::loop:
      // Only the first argument of a call is folded (2.4).
      for (size_t i = 0; i < node(t).children.size(); ++i) {
        const Term child = fold(node(t).children[i], folding && i == 0);
        node(t).children[i] = child;
      }
      return t;
  }
  return t;
}

void TapeBuilder::Expression::fold_float_call(Term t, bool folding) {
  const bool is_power = node(t).function == FloatFunction::pow_;
  for (size_t i = 0; i < node(t).children.size(); ++i) {
    const Term child = fold(node(t).children[i], folding && (i == 0 || is_power));
    node(t).children[i] = child;
  }
  if (is_power && folding && node(t).children.size() == 2 && is_constant(node(t).children[1])) {
    node(t).expand_power = true;
    if (node(node(t).children[1]).value == 0) zero_power = true;
  }
}

Term TapeBuilder::Expression::fold_sequence(Term t, bool folding) {
  // Collect the run of one level: the left spine of the tree.
  const int level = level_of(node(t).op);
  std::vector<Term> terms;
  std::vector<BinaryOperator> operators;
  Term left = t;
  while (node(left).kind == NodeKind::binary && level_of(node(left).op) == level) {
    terms.push_back(node(left).children[1]);
    operators.push_back(node(left).op);
    left = node(left).children[0];
  }
  terms.push_back(left);
  std::vector<Term> run{fold(terms.back(), folding)};
  std::vector<BinaryOperator> between;
  bool variable_seen = folding && contains_variable(run[0]);

  // Left to right with the three rules of spec/functions.md 2.4.
  for (size_t k = operators.size(); k-- > 0;) {
    BinaryOperator op = operators[k];
    Term term = terms[k];
    if (folding) {
      if (op == BinaryOperator::subtract && is_constant(term) && node(term).as_written) {
        op = BinaryOperator::add;
        Node number{NodeKind::constant};
        number.as_written = true;
        number.value = -node(term).value;
        term = add(std::move(number));
      }
      term = fold(term, true);
      variable_seen = variable_seen || contains_variable(term);
      const bool is_product = op == BinaryOperator::multiply || op == BinaryOperator::divide;
      if (is_constant(run.back()) && is_constant(term) && (!is_product || !variable_seen)) {
        // The operator before t[k-1] is not looked at: POV-Ray's bug, wanted for equal pictures.
        Node number{NodeKind::constant};
        number.value = apply(op, node(run.back()).value, node(term).value);
        run.back() = add(std::move(number));
        continue;
      }
    } else {
      term = fold(term, false);
    }
    run.push_back(term);
    between.push_back(op);
  }
  if (run.size() == 1) return run[0];
  Node sequence{NodeKind::sequence};
  sequence.children = std::move(run);
  sequence.operators = std::move(between);
  return add(std::move(sequence));
}

TapeBuilder::TapeBuilder(int parameter_count) : expression_(std::make_unique<Expression>()) {
  expression_->parameter_count = parameter_count;
}

TapeBuilder::~TapeBuilder() = default;

Term TapeBuilder::constant(double value) {
  Expression::Node node{NodeKind::constant};
  node.as_written = true;
  node.value = value;
  return expression_->add(std::move(node));
}

Term TapeBuilder::parameter(int index) {
  Expression::Node node{NodeKind::parameter};
  node.index = index;
  return expression_->add(std::move(node));
}

Term TapeBuilder::negate(Term operand) {
  Expression::Node node{NodeKind::negate};
  node.children = {operand};
  return expression_->add(std::move(node));
}

Term TapeBuilder::parenthesized(Term inside) {
  Expression::Node node{NodeKind::parenthesized};
  node.children = {inside};
  return expression_->add(std::move(node));
}

Term TapeBuilder::binary(BinaryOperator op, Term left, Term right) {
  Expression::Node node{NodeKind::binary};
  node.op = op;
  node.children = {left, right};
  return expression_->add(std::move(node));
}

Term TapeBuilder::call(FloatFunction function, std::vector<Term> arguments) {
  const size_t count = arguments.size();
  size_t least = 1, most = 1;
  switch (function) {
    case FloatFunction::atan2_:
    case FloatFunction::mod:
    case FloatFunction::div: least = most = 2; break;
    case FloatFunction::pow_: most = 2; break;
    case FloatFunction::min:
    case FloatFunction::max: least = 2, most = count; break;
    case FloatFunction::select: least = 3, most = 4; break;
    default: break;
  }
  if (count < least || count > most) {
    std::string wanted = std::to_string(least);
    if (function == FloatFunction::min || function == FloatFunction::max) wanted = "at least 2";
    else if (most != least) wanted += " or " + std::to_string(most);
    throw FunctionError("expected " + wanted + (wanted == "1" ? " argument" : " arguments") +
                        ", found " + std::to_string(count));
  }
  Expression::Node node{NodeKind::float_call};
  node.function = function;
  node.children = std::move(arguments);
  return expression_->add(std::move(node));
}

Term TapeBuilder::call(FunctionHandle function, std::vector<Term> arguments,
                       FunctionMember member) {
  if (static_cast<int>(arguments.size()) != function->parameter_count())
    throw FunctionError("expected " + std::to_string(function->parameter_count()) +
                        " arguments, found " + std::to_string(arguments.size()));
  const int width = function->result_width();
  const bool mixed = member == FunctionMember::grey || member == FunctionMember::height;
  if (mixed ? width < 3 : static_cast<int>(member) >= width)
    throw FunctionError("the function's result has no such component: it has " +
                        std::to_string(width));
  if (function->kind() == FunctionKind::internal && arguments.size() > 4) {
    const auto &h = expression_->node(arguments[3]), &l = expression_->node(arguments[4]);
    if (h.kind == NodeKind::constant && l.kind == NodeKind::constant)
      remember_fractal_use(*function, h.value, l.value);
  }
  Expression::Node node{NodeKind::function_call};
  node.callee = std::move(function);
  node.member = member;
  node.children = std::move(arguments);
  return expression_->add(std::move(node));
}

Term TapeBuilder::call_self(std::vector<Term> arguments) {
  if (static_cast<int>(arguments.size()) != expression_->parameter_count)
    throw FunctionError("expected " + std::to_string(expression_->parameter_count) +
                        " arguments, found " + std::to_string(arguments.size()));
  Expression::Node node{NodeKind::self_call};
  node.children = std::move(arguments);
  return expression_->add(std::move(node));
}

int TapeBuilder::begin_loop() { return expression_->loop_count++; }

Term TapeBuilder::loop_variable(int loop) {
  Expression::Node node{NodeKind::loop_variable};
  node.index = loop;
  return expression_->add(std::move(node));
}

Term TapeBuilder::end_loop(int loop, bool product, Term from, Term to, Term term) {
  Expression::Node node{NodeKind::loop};
  node.index = loop;
  node.product = product;
  node.children = {from, to, term};
  return expression_->add(std::move(node));
}

bool TapeBuilder::folded_zero_power() const { return expression_->zero_power; }

FunctionHandle TapeBuilder::finish(Term body) {
  const Term folded = expression_->fold(body, true);
  return std::make_shared<ExpressionFunction>(write_tape(*expression_, folded));
}

}  // namespace durer
