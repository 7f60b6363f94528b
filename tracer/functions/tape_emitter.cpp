// From a folded expression tree to the tape's instructions.
#include <cmath>
#include <numbers>

#include "tracer/functions/expression_tree.h"

namespace durer {

namespace {

using Term = TapeBuilder::Term;
using NodeKind = ExpressionKind;

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

Tape write_tape(TapeBuilder::Expression& expression, TapeBuilder::Term body) {
  return TapeEmitter(expression).write(body);
}

}  // namespace durer
