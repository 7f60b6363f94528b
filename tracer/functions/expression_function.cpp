#include <cmath>
#include <cstring>

#include "tracer/functions/instruction.h"

namespace durer {

namespace {

constexpr int kMaximumDepth = 1024;  // spec/functions.md 1.3
constexpr int kSmallFrame = 64;

// Truncation through a 32-bit integer; out of range and NaN give the least one (3.3).
double truncate_to_int32(double value) {
  if (value > -2147483649.0 && value < 2147483648.0) return std::trunc(value) + 0.0;
  return -2147483648.0;
}

}  // namespace

ExpressionFunction::ExpressionFunction(Tape tape)
    : CompiledFunction(FunctionKind::expression, tape.parameters, 1), tape_(std::move(tape)) {}

void ExpressionFunction::evaluate(const double* arguments, double* result) const {
  *result = run(arguments, 0);
}

double ExpressionFunction::run(const double* arguments, int depth) const {
  if (depth > kMaximumDepth)
    throw FunctionRecursionError("a function calls itself more than 1024 levels deep");

  // The frame lives on the stack: a fixed one for nearly all functions.
  double small[kSmallFrame];
  double* const r = tape_.registers <= kSmallFrame
                        ? small
                        : static_cast<double*>(__builtin_alloca(
                              static_cast<size_t>(tape_.registers) * sizeof(double)));
  // Nearly all functions are of three numbers: no call for so few.
  if (tape_.parameters == 3) {
    for (int i = 0; i < 3; ++i) r[i] = arguments[i];
  } else {
    std::memcpy(r, arguments, static_cast<size_t>(tape_.parameters) * sizeof(double));
  }

  const Instruction* const code = tape_.code.data();
  const Instruction* const end = code + tape_.code.size();
  for (const Instruction* i = code; i != end; ++i) {
    const double a = r[i->a];
    double& d = r[i->d];
    switch (i->op) {
      case Opcode::load: d = i->constant; break;
      case Opcode::move: d = a; break;
      case Opcode::negate: d = -a; break;
      case Opcode::add: d = a + r[i->b]; break;
      case Opcode::subtract: d = a - r[i->b]; break;
      case Opcode::multiply: d = a * r[i->b]; break;
      case Opcode::divide: d = a / r[i->b]; break;
      case Opcode::add_constant: d = a + i->constant; break;
      case Opcode::subtract_from: d = i->constant - a; break;
      case Opcode::multiply_constant: d = a * i->constant; break;
      case Opcode::divide_into: d = i->constant / a; break;
      // Unordered counts as greater (3.4).
      case Opcode::equal: d = a == r[i->b]; break;
      case Opcode::not_equal: d = a != r[i->b]; break;
      case Opcode::less: d = a < r[i->b]; break;
      case Opcode::less_equal: d = a <= r[i->b]; break;
      case Opcode::greater: d = !(a <= r[i->b]); break;
      case Opcode::greater_equal: d = !(a < r[i->b]); break;
      case Opcode::logical_and: d = a != 0 && r[i->b] != 0; break;
      case Opcode::logical_or: d = a != 0 || r[i->b] != 0; break;
      case Opcode::sin_: d = std::sin(a); break;
      case Opcode::cos_: d = std::cos(a); break;
      case Opcode::tan_: d = std::tan(a); break;
      case Opcode::asin_: d = std::asin(a); break;
      case Opcode::acos_: d = std::acos(a); break;
      case Opcode::atan_: d = std::atan(a); break;
      case Opcode::sinh_: d = std::sinh(a); break;
      case Opcode::cosh_: d = std::cosh(a); break;
      case Opcode::tanh_: d = std::tanh(a); break;
      case Opcode::asinh_: d = std::asinh(a); break;
      case Opcode::acosh_: d = std::acosh(a); break;
      case Opcode::atanh_: d = std::atanh(a); break;
      case Opcode::exp_: d = std::exp(a); break;
      case Opcode::sqrt_: d = std::sqrt(a); break;
      case Opcode::floor_: d = std::floor(a); break;
      case Opcode::ceil_: d = std::ceil(a); break;
      case Opcode::ln: d = std::log(a); break;
      case Opcode::log: d = std::log10(a); break;
      case Opcode::abs: d = std::fabs(a); break;
      case Opcode::int_: d = truncate_to_int32(a); break;
      case Opcode::atan2_: d = std::atan2(a, r[i->b]); break;
      case Opcode::mod: d = std::fmod(a, r[i->b]); break;
      case Opcode::div: d = truncate_to_int32(a / r[i->b]); break;
      case Opcode::pow_: d = std::pow(a, r[i->b]); break;
      case Opcode::min: {
        const double b = r[i->b];
        d = a <= b ? a : b;
        break;
      }
      case Opcode::max: {
        const double b = r[i->b];
        d = b > a ? b : a;
        break;
      }
      case Opcode::jump: i = code + i->target - 1; break;
      case Opcode::jump_unless_negative:
        if (!(a < 0)) i = code + i->target - 1;
        break;
      case Opcode::jump_unless_zero:
        if (a != 0) i = code + i->target - 1;
        break;
      case Opcode::jump_unless_less_equal:
        if (!(a <= r[i->b])) i = code + i->target - 1;
        break;
      case Opcode::call:
        if (i->b == 0 && i->function->result_width() == 1) {
          d = i->function->scalar(r + i->a);
        } else {
          double result[5];
          i->function->evaluate(r + i->a, result);
          d = result[i->b];
        }
        break;
      case Opcode::call_grey: {
        double c[5];
        i->function->evaluate(r + i->a, c);
        d = 0.297 * c[0] + 0.589 * c[1] + 0.114 * c[2];
        break;
      }
      case Opcode::call_height: {
        double c[5];
        i->function->evaluate(r + i->a, c);
        d = (c[0] + c[1] / 255.0) * 0.996093;
        break;
      }
      case Opcode::call_self: d = run(r + i->a, depth + 1); break;
    }
  }
  return r[tape_.result];
}

}  // namespace durer
