// From the expression of a function{} body to a tape that evaluates it.
//
// The parser calls TapeBuilder bottom-up while it reads; finish() folds constants with POV-Ray's
// rules, bugs included (spec/functions.md 2.4), and writes the tape.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include "tracer/functions/compiled_function.h"

namespace durer {

// What is wrong with an expression that parsed, in words for the user ("division by zero").
class FunctionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class BinaryOperator : uint8_t {
  logical_or, logical_and,
  equal, not_equal, less, less_equal, greater, greater_equal,
  add, subtract, multiply, divide,
};

// The float functions of spec/functions.md 2.3, with their number of arguments.
enum class FloatFunction : uint8_t {
  sin_, cos_, tan_, asin_, acos_, atan_, sinh_, cosh_, tanh_, asinh_, acosh_, atanh_, exp_, sqrt_,
  floor_, ceil_, ln, log, abs, int_, radians, degrees,  // 1
  atan2_, mod, div,                                     // 2
  pow_,                                                 // 1 or 2
  min, max,                                             // 2 or more
  select,                                               // 3 or 4
};

// `.x .u .red`, `.y .v .green`, `.z .blue`, `.t .filter`, `.transmit`, `.gray`, `.hf`
enum class FunctionMember : uint8_t { first, second, third, fourth, fifth, grey, height };

class TapeBuilder {
 public:
  // A part of the expression: an index into the builder.
  struct Term {
    int32_t id = -1;
  };

  explicit TapeBuilder(int parameter_count);
  ~TapeBuilder();
  TapeBuilder(const TapeBuilder&) = delete;
  TapeBuilder& operator=(const TapeBuilder&) = delete;

  // A literal, a declared float, pi, clock.
  Term constant(double value);
  // Parameter by index; -1: one of x y z u v that is not among the parameters, always 0.
  Term parameter(int index);
  Term negate(Term operand);
  // `( EXPR )`: call it for every pair of parentheses in the text, they stop folding.
  Term parenthesized(Term inside);
  // Left operand first: a - b + c is binary(add, binary(subtract, a, b), c).
  Term binary(BinaryOperator op, Term left, Term right);
  // Numbers of arguments are checked: FunctionError.
  Term call(FloatFunction function, std::vector<Term> arguments);
  // A declared function. Member: only of vector functions (FunctionError if it has no such
  // component). The argument count must be right: FunctionError.
  Term call(FunctionHandle function, std::vector<Term> arguments,
            FunctionMember member = FunctionMember::first);
  // The function being declared calls itself.
  Term call_self(std::vector<Term> arguments);

  // sum(name, from, to, term) and prod: open the loop when its name is read, build from, to and term
  // with loop_variable(loop) for the name, then close it.
  int begin_loop();
  Term loop_variable(int loop);
  Term end_loop(int loop, bool product, Term from, Term to, Term term);

  // True after finish() replaced a pow(t, 0) by 1: worth a warning.
  bool folded_zero_power() const;

  // Throws FunctionError("division by zero") for `t / 0`.
  FunctionHandle finish(Term body);

  struct Expression;  // expression_tree.h

 private:
  std::unique_ptr<Expression> expression_;
};

}  // namespace durer
