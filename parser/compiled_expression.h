// Numeric expressions that are read again and again (bodies of loops and macros), compiled once
// into a straight run of steps over scalar registers.
//
// Widths are known when an expression is compiled, because the kinds of its identifiers are those
// found at that moment: vectors are lists of registers, promotion and `.x` cost nothing. A step
// checks what it relies on (the identifier still has that kind, the subscript is in range, the
// divisor is not zero ...); where that fails nothing has been consumed and the tokens are read in
// the ordinary way, which also gives all warnings and errors.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "parser/token.h"

namespace durer {

// The level of the grammar at which an expression is read: `a + b`, or with comparisons and `?:`.
enum class ExpressionLevel : uint8_t { sum, express };

// Levels that a compiled expression has at most, and calls of rand().
inline constexpr int kCompiledNesting = 32;
inline constexpr int kCompiledRandoms = 8;

struct CompiledExpression {
  enum class Operation : uint8_t {
    // From variables: `name`, `count` terms.
    number, vector, element_number, element_vector, first_subscript, next_subscript, dimension_size,
    // Operators.
    add, subtract, multiply, divide, negate, not_, compare, both, either, choose,
    // Functions of one and of two floats.
    abs, floor, ceil, exp, sin, cos, tan, sinh, cosh, tanh, atan, asinh, acosh, atanh, acos, asin,
    sqrt, ln, log, int_, degrees, radians, rand, atan2, pow, mod, div, min, max,
    // Functions of many floats.
    select, vdot, vlength, vcross, vnormalize, vrotate, vaxis_rotate, call,
  };

  struct Step {
    Operation operation;
    uint8_t count = 0;      // terms, dimensions or arguments
    uint16_t to = 0;        // first register written
    uint16_t a = 0, b = 0;  // registers read
    uint16_t list = 0;      // functions of many floats: where theirs begin in `operands`
    uint32_t name = 0;      // of the variable; choose: the condition's register
  };

  std::vector<Step> steps;
  std::vector<double> registers;  // constants stand in them from the beginning
  std::vector<uint16_t> operands;
  std::array<uint16_t, 5> result{};
  int count = 0;        // terms of the result
  int kept = 0;         // those and what a selection left behind them
  int width = 1;        // that the context expects
  ExpressionLevel level = ExpressionLevel::sum;
  bool is_identifier = false;  // one variable or element and nothing else: passed by reference
  uint32_t tokens = 0;         // how many it has; the one behind it is no part of it
  int misses = 0;              // in a row
};

// What a page knows of the expressions that begin at its tokens.
struct ExpressionCache {
  struct Place {
    uint8_t visits = 0;
    uint8_t attempts = 0;
    uint16_t expression = 0;  // one more than the place in `expressions`; 0: none
  };
  std::vector<Place> places;  // by token
  std::vector<std::unique_ptr<CompiledExpression>> expressions;
};

}  // namespace durer
