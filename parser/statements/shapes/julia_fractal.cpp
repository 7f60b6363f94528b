// julia_fractal (spec/geometry.md 12.15).
#include <algorithm>
#include <cmath>

#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {

ShapeNode parse_julia_fractal(Parser& parser) {
  using Function = JuliaFractalNode::Function;
  struct Word {
    Keyword keyword;
    Function function;
  };
  static constexpr Word kWords[] = {
      {Keyword::sqr, Function::sqr},     {Keyword::cube, Function::cube},
      {Keyword::exp, Function::exp},     {Keyword::reciprocal, Function::reciprocal},
      {Keyword::sin, Function::sin},     {Keyword::asin, Function::asin},
      {Keyword::sinh, Function::sinh},   {Keyword::asinh, Function::asinh},
      {Keyword::cos, Function::cos},     {Keyword::acos, Function::acos},
      {Keyword::cosh, Function::cosh},   {Keyword::acosh, Function::acosh},
      {Keyword::tan, Function::tan},     {Keyword::atan, Function::atan},
      {Keyword::tanh, Function::tanh},   {Keyword::atanh, Function::atanh},
      {Keyword::ln, Function::log},
  };
  JuliaFractalNode node;
  node.parameter = parser.parse_vec4();
  for (;;) {
    bool matched = false;
    for (const Word& word : kWords) {
      if (!parser.accept(word.keyword)) continue;
      node.function = word.function;
      matched = true;
      break;
    }
    if (matched) continue;
    if (parser.accept(Keyword::max_iteration)) {
      node.max_iteration = std::max(1, parser.parse_int());
    } else if (parser.accept(Keyword::slice)) {
      node.slice = parser.parse_vec4();
      parser.accept_comma();
      node.slice_distance = parser.parse_float();
      if (glm::dot(node.slice, node.slice) == 0) {
        parser.error("the normal of a slice must not be the zero vector");
      }
      if (std::abs(node.slice.w) < 1e-10) {
        parser.error("the fourth component of a slice's normal must not be zero");
      }
    } else if (parser.accept(Keyword::precision)) {
      node.precision = std::max(1.0, parser.parse_float());
    } else if (parser.accept(Keyword::quaternion)) {
      node.algebra = JuliaFractalNode::Algebra::quaternion;
    } else if (parser.accept(Keyword::hypercomplex)) {
      node.algebra = JuliaFractalNode::Algebra::hypercomplex;
    } else if (parser.accept(Keyword::pwr)) {
      node.function = Function::pwr;
      parser.expect(Symbol::paren_open);
      node.power.x = parser.parse_float();
      parser.accept_comma();
      node.power.y = parser.parse_float();
      parser.expect(Symbol::paren_close);
    } else {
      break;
    }
  }
  if (node.algebra == JuliaFractalNode::Algebra::quaternion && node.function != Function::sqr &&
      node.function != Function::cube) {
    parser.error("quaternions know only sqr and cube");
  }
  return node;
}

}  // namespace durer
