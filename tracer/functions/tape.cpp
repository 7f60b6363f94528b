#include "tracer/functions/tape.h"

#include <cmath>
#include <numbers>
#include <string>

#include "tracer/functions/instruction.h"

namespace durer {

namespace {

using Term = TapeBuilder::Term;

enum class NodeKind : uint8_t {
  constant, parameter, loop_variable, negate, parenthesized, binary, sequence, float_call,
  function_call, self_call, loop,
};

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

Opcode opcode_of(BinaryOperator op) {
  switch (op) {
    case BinaryOperator::logical_or: return Opcode::logical_or;
    case BinaryOperator::logical_and: return Opcode::logical_and;
    case BinaryOperator::equal: return Opcode::equal;
    case BinaryOperator::not_equal: return Opcode::not_equal;
    case BinaryOperator::less: return Opcode::less;
    case BinaryOperator::less_equal: return Opcode::less_equal;
    case BinaryOperator::greater: return Opcode::greater;
    case BinaryOperator::greater_equal: return Opcode::greater_equal;
    case BinaryOperator::add: return Opcode::add;
    case BinaryOperator::subtract: return Opcode::subtract;
    case BinaryOperator::multiply: return Opcode::multiply;
    case BinaryOperator::divide: return Opcode::divide;
  }
  return Opcode::add;
}

Opcode opcode_of(FloatFunction function) {
  switch (function) {
    case FloatFunction::sin_: return Opcode::sin_;
    case FloatFunction::cos_: return Opcode::cos_;
    case FloatFunction::tan_: return Opcode::tan_;
    case FloatFunction::asin_: return Opcode::asin_;
    case FloatFunction::acos_: return Opcode::acos_;
    case FloatFunction::atan_: return Opcode::atan_;
    case FloatFunction::sinh_: return Opcode::sinh_;
    case FloatFunction::cosh_: return Opcode::cosh_;
    case FloatFunction::tanh_: return Opcode::tanh_;
    case FloatFunction::asinh_: return Opcode::asinh_;
    case FloatFunction::acosh_: return Opcode::acosh_;
    case FloatFunction::atanh_: return Opcode::atanh_;
    case FloatFunction::exp_: return Opcode::exp_;
    case FloatFunction::sqrt_: return Opcode::sqrt_;
    case FloatFunction::floor_: return Opcode::floor_;
    case FloatFunction::ceil_: return Opcode::ceil_;
    case FloatFunction::ln: return Opcode::ln;
    case FloatFunction::log: return Opcode::log;
    case FloatFunction::abs: return Opcode::abs;
    case FloatFunction::int_: return Opcode::int_;
    case FloatFunction::atan2_: return Opcode::atan2_;
    case FloatFunction::mod: return Opcode::mod;
    case FloatFunction::div: return Opcode::div;
    case FloatFunction::pow_: return Opcode::pow_;
    case FloatFunction::min: return Opcode::min;
    case FloatFunction::max: return Opcode::max;
    // Not single instructions: written out by the emitter.
    case FloatFunction::radians:
    case FloatFunction::degrees:
    case FloatFunction::select: break;
  }
  return Opcode::move;
}

}  // namespace

struct TapeBuilder::Expression {
  struct Node {
    explicit Node(NodeKind node_kind) : kind(node_kind) {}

    NodeKind kind;
    bool as_written = false;  // constant: a literal or identifier, not a folded number
    bool expand_power = false;  // float_call pow: in folded position
    bool product = false;       // loop
    BinaryOperator op{};
    FloatFunction function{};
    FunctionMember member{};
    int index = 0;  // parameter, loop
    double value = 0;
    FunctionHandle callee;
    std::vector<Term> children;
    std::vector<BinaryOperator> operators;  // sequence: between children
  };

  int parameter_count = 0;
  int loop_count = 0;
  bool zero_power = false;
  std::vector<Node> nodes;

  Term add(Node node) {
    nodes.push_back(std::move(node));
    return {static_cast<int32_t>(nodes.size()) - 1};
  }
  Node& node(Term t) { return nodes[static_cast<size_t>(t.id)]; }

  bool is_constant(Term t) { return node(t).kind == NodeKind::constant; }

  bool contains_variable(Term t) {
    const Node& n = node(t);
    if (n.kind == NodeKind::parameter || n.kind == NodeKind::loop_variable) return true;
    for (Term child : n.children)
      if (contains_variable(child)) return true;
    return false;
  }

  // Turns chains of one level into sequences and folds them where `folding`.
  Term fold(Term t, bool folding);
  Term fold_sequence(Term t, bool folding);
  void fold_float_call(Term t, bool folding);
};

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

namespace {

constexpr int kMaximumRegisters = 60000;
constexpr size_t kMaximumCode = 1000000;  // "about one million instructions" (1.3)
constexpr size_t kInlineLimit = 400;      // callees up to this length are written in place

}  // namespace

// Writes the tape: each term to a register at or above `target`, or to its parameter's register.
class TapeEmitter {
 public:
  using Expression = TapeBuilder::Expression;
  using Node = Expression::Node;

  explicit TapeEmitter(Expression& expression) : expression_(expression) {
    tape_.parameters = expression.parameter_count;
    tape_.registers = expression.parameter_count;
    loop_registers_.resize(static_cast<size_t>(expression.loop_count), 0);
  }

  Tape write(Term body) {
    tape_.result = emit(body, tape_.parameters);
    return std::move(tape_);
  }

 private:
  void reserve(int reg) {
    if (reg >= kMaximumRegisters || tape_.code.size() > kMaximumCode)
      throw FunctionError("function is too complex");
    if (reg >= tape_.registers) tape_.registers = reg + 1;
  }
  Instruction& push(Opcode op, int d, int a = 0, int b = 0) {
    reserve(d);
    tape_.code.emplace_back(op, d, a, b);
    return tape_.code.back();
  }
  int load(double value, int target) {
    push(Opcode::load, target).constant = value;
    return target;
  }
  // The lowest register that is free while `reg` is still needed.
  static int above(int reg, int target) { return reg >= target ? reg + 1 : target; }
  int32_t here() const { return static_cast<int32_t>(tape_.code.size()); }
  // Emits and makes sure that the value lies in `target` itself.
  void emit_into(Term t, int target) {
    const int reg = emit(t, target);
    if (reg != target) push(Opcode::move, target, reg);
  }

  int emit(Term t, int target);
  int emit_sequence(const Node& node, int target);
  int emit_float_call(const Node& node, int target);
  int emit_power(const Node& node, int target);
  int emit_select(const Node& node, int target);
  int emit_loop(const Node& node, int target);
  int emit_function_call(const Node& node, int target);
  int inline_call(const Node& node, const Tape& callee, int target);

  Expression& expression_;
  Tape tape_;
  std::vector<int> loop_registers_;
};

int TapeEmitter::emit(Term t, int target) {
  const Node& node = expression_.node(t);
  switch (node.kind) {
    case NodeKind::constant: return load(node.value, target);
    case NodeKind::parameter: return node.index < 0 ? load(0, target) : node.index;
    case NodeKind::loop_variable: return loop_registers_[static_cast<size_t>(node.index)];
    case NodeKind::parenthesized: return emit(node.children[0], target);
    case NodeKind::negate: {
      const int a = emit(node.children[0], target);
      push(Opcode::negate, target, a);
      return target;
    }
    case NodeKind::binary: break;  // fold() has made sequences of them
    case NodeKind::sequence: return emit_sequence(node, target);
    case NodeKind::float_call: return emit_float_call(node, target);
    case NodeKind::function_call: return emit_function_call(node, target);
    case NodeKind::self_call:
      for (size_t i = 0; i < node.children.size(); ++i)
        emit_into(node.children[i], target + static_cast<int>(i));
      push(Opcode::call_self, target, target);
      tape_.calls_itself = true;
      return target;
    case NodeKind::loop: return emit_loop(node, target);
  }
  return target;
}

int TapeEmitter::emit_sequence(const Node& node, int target) {
  const Node& first = expression_.node(node.children[0]);
  // A constant first term joins the instruction of the second.
  bool pending = first.kind == NodeKind::constant;
  const double pending_value = first.value;
  int left = pending ? target : emit(node.children[0], target);
  for (size_t k = 1; k < node.children.size(); ++k) {
    const BinaryOperator op = node.operators[k - 1];
    const Node& term = expression_.node(node.children[k]);
    const bool constant = term.kind == NodeKind::constant;
    const double c = term.value;
    if (constant && op == BinaryOperator::divide && c == 0)
      throw FunctionError("division by zero");
    if (pending) {
      pending = false;
      Opcode joined;
      bool can_join = !constant;
      switch (op) {
        case BinaryOperator::add: joined = Opcode::add_constant; break;
        case BinaryOperator::subtract: joined = Opcode::subtract_from; break;
        case BinaryOperator::multiply: joined = Opcode::multiply_constant; break;
        case BinaryOperator::divide: joined = Opcode::divide_into; break;
        default: joined = Opcode::load; can_join = false; break;
      }
      if (can_join) {
        const int right = emit(node.children[k], target);
        push(joined, target, right).constant = pending_value;
        left = target;
        continue;
      }
      left = load(pending_value, target);
    }
    if (constant && op == BinaryOperator::add) {
      if (c != 0) push(Opcode::add_constant, target, left).constant = c, left = target;
    } else if (constant && op == BinaryOperator::subtract) {
      if (c != 0) push(Opcode::add_constant, target, left).constant = -c, left = target;
    } else if (constant && op == BinaryOperator::multiply) {
      if (c != 1) push(Opcode::multiply_constant, target, left).constant = c, left = target;
    } else if (constant && op == BinaryOperator::divide) {
      // Division by a constant is multiplication by its rounded reciprocal (2.4 rule 4).
      if (c != 1) push(Opcode::multiply_constant, target, left).constant = 1 / c, left = target;
    } else {
      const int right = emit(node.children[k], above(left, target));
      push(opcode_of(op), target, left, right);
      left = target;
    }
  }
  return left;
}

int TapeEmitter::emit_float_call(const Node& node, int target) {
  const auto& arguments = node.children;
  switch (node.function) {
    case FloatFunction::radians:
    case FloatFunction::degrees: {
      const int a = emit(arguments[0], target);
      push(Opcode::multiply_constant, target, a).constant =
          node.function == FloatFunction::radians ? std::numbers::pi / 180 : 180 / std::numbers::pi;
      return target;
    }
    case FloatFunction::select: return emit_select(node, target);
    case FloatFunction::pow_:
      if (arguments.size() == 1) return emit(arguments[0], target);
      if (node.expand_power) return emit_power(node, target);
      break;
    default: break;
  }
  int left = emit(arguments[0], target);
  if (arguments.size() == 1) {
    push(opcode_of(node.function), target, left);
    return target;
  }
  for (size_t i = 1; i < arguments.size(); ++i) {
    const int right = emit(arguments[i], above(left, target));
    push(opcode_of(node.function), target, left, right);
    left = target;
  }
  return target;
}

int TapeEmitter::emit_power(const Node& node, int target) {
  const double exponent = expression_.node(node.children[1]).value;
  if (exponent == 0) return load(1, target);
  const int p = emit(node.children[0], target);
  const bool small = exponent >= 2 && exponent <= 8 && exponent == std::floor(exponent);
  const int q = above(p, target), result = q + 1;
  if (!small) {
    load(exponent, q);
    push(Opcode::pow_, target, p, q);
    return target;
  }
  // p*p, (p*p)*p, q*q, (q*q)*p, (q*q)*q, ((q*q)*p)*q, (q*q)*(q*q) with q = p*p (rule 5).
  const int n = static_cast<int>(exponent);
  push(Opcode::multiply, q, p, p);
  if (n == 2) return q;
  if (n == 3) {
    push(Opcode::multiply, result, q, p);
    return result;
  }
  push(Opcode::multiply, result, q, q);
  if (n == 5 || n == 7) push(Opcode::multiply, result, result, p);
  if (n == 6 || n == 7) push(Opcode::multiply, result, result, q);
  if (n == 8) push(Opcode::multiply, result, result, result);
  return result;
}

int TapeEmitter::emit_select(const Node& node, int target) {
  const int c = emit(node.children[0], target);
  const int result = above(c, target);
  reserve(result);
  const int32_t to_other = here();
  push(Opcode::jump_unless_negative, result, c);
  emit_into(node.children[1], result);
  const int32_t to_end = here();
  push(Opcode::jump, result);
  tape_.code[static_cast<size_t>(to_other)].target = here();
  if (node.children.size() == 3) {
    emit_into(node.children[2], result);
  } else {
    const int32_t to_positive = here();
    push(Opcode::jump_unless_zero, result, c);
    emit_into(node.children[2], result);
    const int32_t zero_to_end = here();
    push(Opcode::jump, result);
    tape_.code[static_cast<size_t>(to_positive)].target = here();
    emit_into(node.children[3], result);
    tape_.code[static_cast<size_t>(zero_to_end)].target = here();
  }
  tape_.code[static_cast<size_t>(to_end)].target = here();
  return result;
}

int TapeEmitter::emit_loop(const Node& node, int target) {
  const int total = target, counter = target + 1, limit = target + 2, scratch = target + 3;
  reserve(scratch);
  loop_registers_[static_cast<size_t>(node.index)] = counter;
  load(0, counter);
  emit_into(node.children[0], scratch);
  emit_into(node.children[1], limit);
  push(Opcode::move, counter, scratch);
  load(node.product ? 1 : 0, total);
  const int32_t start = here();
  push(Opcode::jump_unless_less_equal, scratch, counter, limit);
  const int term = emit(node.children[2], scratch);
  push(node.product ? Opcode::multiply : Opcode::add, total, total, term);
  push(Opcode::add_constant, counter, counter).constant = 1;
  push(Opcode::jump, scratch).target = start;
  tape_.code[static_cast<size_t>(start)].target = here();
  return total;
}

int TapeEmitter::emit_function_call(const Node& node, int target) {
  if (const auto* callee = dynamic_cast<const ExpressionFunction*>(node.callee.get())) {
    if (!callee->tape().calls_itself && callee->tape().code.size() <= kInlineLimit)
      return inline_call(node, callee->tape(), target);
  }
  for (size_t i = 0; i < node.children.size(); ++i)
    emit_into(node.children[i], target + static_cast<int>(i));
  Opcode op = Opcode::call;
  int component = 0;
  if (node.member == FunctionMember::grey) op = Opcode::call_grey;
  else if (node.member == FunctionMember::height) op = Opcode::call_height;
  else component = static_cast<int>(node.member);
  push(op, target, target, component).function = node.callee.get();
  tape_.callees.push_back(node.callee);
  return target;
}

// Copies the callee's steps with its registers renamed: parameters become the arguments' registers.
int TapeEmitter::inline_call(const Node& node, const Tape& callee, int target) {
  std::vector<int> argument_registers;
  int next = target;
  for (Term argument : node.children) {
    const int reg = emit(argument, next);
    argument_registers.push_back(reg);
    next = above(reg, next);
  }
  const auto renamed = [&](int reg) {
    return reg < callee.parameters ? argument_registers[static_cast<size_t>(reg)]
                                   : next + reg - callee.parameters;
  };
  reserve(next + callee.registers - callee.parameters);
  const int32_t offset = here();
  for (Instruction i : callee.code) {
    const bool is_call = i.op == Opcode::call || i.op == Opcode::call_grey ||
                         i.op == Opcode::call_height;
    const bool is_jump = i.op >= Opcode::jump && i.op <= Opcode::jump_unless_less_equal;
    i.d = static_cast<uint16_t>(renamed(i.d));
    i.a = static_cast<uint16_t>(renamed(i.a));
    if (!is_call) i.b = static_cast<uint16_t>(renamed(i.b));
    if (is_jump) i.target += offset;
    tape_.code.push_back(i);
  }
  tape_.callees.insert(tape_.callees.end(), callee.callees.begin(), callee.callees.end());
  return renamed(callee.result);
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
  return std::make_shared<ExpressionFunction>(TapeEmitter(*expression_).write(folded));
}

}  // namespace durer
