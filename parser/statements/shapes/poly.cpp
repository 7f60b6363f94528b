// cubic, quartic, poly, polynomial: algebraic surfaces (spec/geometry.md 14.3).
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {
namespace {

constexpr int kMostOrder = 35;

int coefficient_count(int order) { return (order + 1) * (order + 2) * (order + 3) / 6; }

ShapeNode parse_of_order(Parser& parser, int order, const char* what) {
  PolyNode node;
  node.order = order;
  node.coefficients.resize(coefficient_count(order));
  parser.parse_number_list(node.coefficients.data(), coefficient_count(order), what);
  return node;
}

int parse_order(Parser& parser) {
  const int order = parser.parse_int();
  parser.accept_comma();
  if (order < 2 || order > kMostOrder) {
    parser.error("the order of a polynomial must lie between 2 and 35");
  }
  return order;
}

// Place of x^a y^b z^c among the coefficients: by falling powers of x, then y, then z.
int coefficient_index(int order, int a, int b, int c) {
  int index = 0;
  for (int i = order; i >= 0; --i) {
    for (int j = order - i; j >= 0; --j) {
      for (int k = order - i - j; k >= 0; --k) {
        if (i == a && j == b && k == c) return index;
        ++index;
      }
    }
  }
  return -1;
}

}  // namespace

ShapeNode parse_cubic(Parser& parser) { return parse_of_order(parser, 3, "cubic"); }
ShapeNode parse_quartic(Parser& parser) { return parse_of_order(parser, 4, "quartic"); }
ShapeNode parse_poly(Parser& parser) {
  const int order = parse_order(parser);
  return parse_of_order(parser, order, "poly");
}

ShapeNode parse_polynomial(Parser& parser) {
  PolyNode node;
  node.order = parse_order(parser);
  node.coefficients.assign(coefficient_count(node.order), 0.0);
  while (parser.accept(Keyword::xyz)) {
    parser.expect(Symbol::paren_open);
    int power[3];
    for (int& p : power) {
      p = parser.parse_int();
      parser.accept_comma();
    }
    parser.expect(Symbol::paren_close);
    parser.expect(Symbol::colon);
    const double coefficient = parser.parse_float();
    parser.accept_comma();
    const int index = coefficient_index(node.order, power[0], power[1], power[2]);
    if (index < 0) parser.error("the powers of this term do not fit the polynomial's order");
    node.coefficients[index] = coefficient;
  }
  return node;
}

}  // namespace durer
