// The tape of function{}: POV-Ray's folding (spec/functions.md 2.4) and edge cases (3).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tracer/functions/tape.h"

namespace durer {
namespace {

using Op = BinaryOperator;

double at(const FunctionHandle& f, double x) { return f->scalar(&x); }

TEST(Tape, FoldsARunWithoutLookingAtTheOperatorBefore) {
  TapeBuilder b(1);
  // x - 2*3 + 4 at 0 is read as x - (6 + 4).
  const auto product = b.binary(Op::multiply, b.constant(2), b.constant(3));
  const auto sum = b.binary(Op::add, b.binary(Op::subtract, b.parameter(0), product), b.constant(4));
  EXPECT_EQ(at(b.finish(sum), 0), -10);
}

TEST(Tape, SubtractedLiteralsFoldRight) {
  TapeBuilder b(1);
  auto sum = b.binary(Op::subtract, b.parameter(0), b.constant(2));
  sum = b.binary(Op::add, sum, b.constant(3));
  sum = b.binary(Op::subtract, sum, b.constant(4));
  sum = b.binary(Op::add, sum, b.constant(5));
  EXPECT_EQ(at(b.finish(sum), 0), 2);
}

TEST(Tape, ParenthesesStopFolding) {
  TapeBuilder b(1);
  const auto quotient =
      b.binary(Op::divide, b.parameter(0), b.parenthesized(b.constant(3)));
  EXPECT_EQ(at(b.finish(quotient), 10), 10.0 / 3.0);
  TapeBuilder c(1);
  EXPECT_EQ(at(c.finish(c.binary(Op::divide, c.parameter(0), c.constant(3))), 10),
            10 * (1.0 / 3.0));
}

TEST(Tape, DivisionByALiteralZeroIsAnError) {
  TapeBuilder b(1);
  EXPECT_THROW(b.finish(b.binary(Op::divide, b.parameter(0), b.constant(0))), FunctionError);
}

TEST(Tape, PowersBecomeProductsOnlyWhereFolded) {
  TapeBuilder b(1);
  EXPECT_EQ(at(b.finish(b.call(FloatFunction::pow_, {b.parameter(0), b.constant(6)})), 1.3),
            4.82680900000000168);
  TapeBuilder c(1);
  const auto power = c.call(FloatFunction::pow_, {c.parameter(0), c.constant(6)});
  EXPECT_EQ(at(c.finish(c.call(FloatFunction::min, {c.constant(100), power})), 1.3),
            4.82680900000000079);
}

TEST(Tape, LoopsNestAndSelectBranches) {
  // sum(i, 1, 3, prod(j, 1, i, select(x, j, 1, 2)))
  TapeBuilder b(1);
  const int i = b.begin_loop();
  const auto from = b.constant(1), to = b.constant(3);
  const int j = b.begin_loop();
  const auto inner = b.end_loop(
      j, true, b.constant(1), b.loop_variable(i),
      b.call(FloatFunction::select, {b.parameter(0), b.loop_variable(j), b.constant(1),
                                     b.constant(2)}));
  const auto f = b.finish(b.end_loop(i, false, from, to, inner));
  EXPECT_EQ(at(f, -1), 1 + 2 + 6);
  EXPECT_EQ(at(f, 0), 3);
  EXPECT_EQ(at(f, 1), 2 + 4 + 8);
}

TEST(Tape, CallsAreWrittenInPlaceAndRecursionIsBounded) {
  TapeBuilder g(2);  // x - 2*y
  const auto callee = g.finish(g.binary(
      Op::subtract, g.parameter(0), g.binary(Op::multiply, g.constant(2), g.parameter(1))));
  TapeBuilder b(1);  // g(g(x, 1), x)
  const auto inner = b.call(callee, {b.parameter(0), b.constant(1)});
  EXPECT_EQ(at(b.finish(b.call(callee, {inner, b.parameter(0)})), 5), 5 - 2 - 10);

  TapeBuilder r(1);  // select(x, 0, x + f(x-1))
  const auto less = r.binary(Op::subtract, r.parameter(0), r.constant(1));
  const auto sum = r.binary(Op::add, r.parameter(0), r.call_self({less}));
  const auto f = r.finish(r.call(FloatFunction::select, {r.parameter(0), r.constant(0), sum}));
  EXPECT_EQ(at(f, 3), 6);
  EXPECT_THROW(at(f, 5000), FunctionRecursionError);
}

TEST(Tape, NotANumberComparesAsGreater) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Op ops[] = {Op::less, Op::less_equal, Op::equal, Op::not_equal, Op::greater,
                    Op::greater_equal};
  const double expected[] = {0, 0, 0, 1, 1, 1};
  for (int i = 0; i < 6; ++i) {
    TapeBuilder b(1);
    EXPECT_EQ(at(b.finish(b.binary(ops[i], b.constant(1), b.parameter(0))), nan), expected[i]);
  }
}

}  // namespace
}  // namespace durer
