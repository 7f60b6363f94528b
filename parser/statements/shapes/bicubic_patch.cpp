// bicubic_patch (spec/geometry.md 13.6).
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {
namespace {

// What begins a number and cannot begin a point.
bool at_float(Parser& parser) {
  const Token& token = parser.peek();
  switch (token.kind) {
    case TokenKind::number:
      return true;
    case TokenKind::symbol:
      return token.symbol == Symbol::paren_open || token.symbol == Symbol::plus ||
             token.symbol == Symbol::minus || token.symbol == Symbol::exclamation;
    case TokenKind::identifier:
      return parser.at_identifier(ValueKind::number) || parser.at_identifier(ValueKind::function);
    case TokenKind::keyword:
      return parser.at_expression() &&
             !parser.at_any({Keyword::x, Keyword::y, Keyword::z, Keyword::u, Keyword::v, Keyword::t,
                             Keyword::max_extent, Keyword::min_extent, Keyword::trace,
                             Keyword::vaxis_rotate, Keyword::vcross, Keyword::vnormalize,
                             Keyword::vrotate, Keyword::vturbulence});
    default:
      return false;
  }
}

// The oldest form: the type, the flatness of types 2 and 3, the steps, without keywords or commas.
void parse_bare_numbers(Parser& parser, BicubicPatchNode& node) {
  parser.warning("the parameters of a bicubic_patch should have their keywords");
  node.type = parser.parse_int();
  node.flatness = node.type == 2 || node.type == 3 ? parser.parse_float() : 0.1;
  node.u_steps = parser.parse_int();
  node.v_steps = parser.parse_int();
}

}  // namespace

ShapeNode parse_bicubic_patch(Parser& parser) {
  BicubicPatchNode node;
  node.type = -1;
  for (;;) {
    if (parser.accept(Keyword::type)) {
      node.type = parser.parse_int();
    } else if (parser.accept(Keyword::flatness)) {
      node.flatness = parser.parse_float();
    } else if (parser.accept(Keyword::u_steps)) {
      node.u_steps = parser.parse_int();
    } else if (parser.accept(Keyword::v_steps)) {
      node.v_steps = parser.parse_int();
    } else if (parser.accept(Keyword::accuracy)) {
      node.accuracy = parser.parse_float();
    } else {
      break;
    }
  }
  // Either of these is the last parameter.
  if (parser.accept(Keyword::uv_vectors)) {
    std::array<Vec2, 4> uv;
    for (Vec2& corner : uv) {
      corner = parser.parse_uv();
      parser.accept_comma();
    }
    node.uv = uv;
  } else if (at_float(parser)) {
    parse_bare_numbers(parser, node);
  }
  parser.accept_comma();
  if (node.type < 0) parser.error("a bicubic_patch needs its type: 'type 0' or 'type 1'");
  if (node.type > 1) {
    parser.warning("this type of bicubic_patch exists no more; type 1 is used");
    node.type = 1;
  }
  for (Vec3& point : node.points) {
    point = parser.parse_vector();
    if (&point != &node.points.back()) parser.accept_comma();
  }
  return node;
}

}  // namespace durer
