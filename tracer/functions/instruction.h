// One step of a function's tape.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/functions/compiled_function.h"

namespace durer {

// d = destination, a b = source registers, c = constant.
enum class Opcode : uint16_t {
  load,       // d = c
  move,       // d = a
  negate, add, subtract, multiply, divide,                      // d = a op b
  add_constant, subtract_from, multiply_constant, divide_into,  // d = a+c, c-a, a*c, c/a
  equal, not_equal, less, less_equal, greater, greater_equal, logical_and, logical_or,
  sin_, cos_, tan_, asin_, acos_, atan_, sinh_, cosh_, tanh_, asinh_, acosh_, atanh_, exp_, sqrt_,
  floor_, ceil_, ln, log, abs, int_,
  atan2_, mod, div, pow_, min, max,
  jump,                  // go on at `target`
  jump_unless_negative,  // if not a < 0
  jump_unless_zero,      // if a != 0 or NaN
  jump_unless_less_equal,  // if not a <= b
  call,       // d = component of function(registers from a on)
  call_grey,  // d = 0.297 d0 + 0.589 d1 + 0.114 d2
  call_height,
  call_self,  // d = this function(registers from a on)
};

struct Instruction {
  Opcode op;
  uint16_t d = 0, a = 0, b = 0;  // call: b is the component
  union {
    double constant;
    int32_t target;
    const CompiledFunction* function;
  };

  Instruction(Opcode opcode, int destination, int first, int second)
      : op(opcode), d(static_cast<uint16_t>(destination)), a(static_cast<uint16_t>(first)),
        b(static_cast<uint16_t>(second)), constant(0) {}
};

struct Tape {
  std::vector<Instruction> code;
  // Registers 0 .. parameters-1 hold the arguments and are never written.
  int parameters = 0;
  int registers = 0;
  int result = 0;  // the register that holds the value at the end
  bool calls_itself = false;
  std::vector<FunctionHandle> callees;  // keeps alive what `call` points to
};

// A function whose body is an expression.
class ExpressionFunction final : public CompiledFunction {
 public:
  explicit ExpressionFunction(Tape tape);

  const Tape& tape() const { return tape_; }
  void evaluate(const double* arguments, double* result) const override;
  double scalar(const double* arguments) const override { return run(arguments, 0); }

 private:
  double run(const double* arguments, int depth) const;

  Tape tape_;
};

}  // namespace durer
