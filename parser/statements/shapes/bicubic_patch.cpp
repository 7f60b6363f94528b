// bicubic_patch (spec/geometry.md 13.6).
#include <algorithm>

#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {
namespace {

int checked_type(Parser& parser) {
  const int type = parser.parse_int();
  if (type < 0) parser.error("a bicubic_patch is of type 0 or 1");
  if (type > 1) parser.warning("this type of bicubic_patch exists no more; type 1 is used");
  return type;
}

}  // namespace

ShapeNode parse_bicubic_patch(Parser& parser) {
  BicubicPatchNode node;
  bool has_type = false;
  // The oldest form has bare numbers: the type, the flatness of types 2 and 3, the steps.
  if (parser.peek().kind == TokenKind::number) {
    parser.possible_error("the parameters of a bicubic_patch should have their keywords");
    node.type = checked_type(parser);
    has_type = true;
    node.flatness = 0.1;
    parser.accept_comma();
    if (node.type > 1) node.flatness = parser.parse_float();
    parser.accept_comma();
    node.u_steps = parser.parse_int();
    parser.accept_comma();
    node.v_steps = parser.parse_int();
    parser.accept_comma();
  }
  for (;;) {
    if (parser.accept(Keyword::type)) {
      node.type = checked_type(parser);
      has_type = true;
    } else if (parser.accept(Keyword::flatness)) {
      node.flatness = parser.parse_float();
    } else if (parser.accept(Keyword::u_steps)) {
      node.u_steps = parser.parse_int();
    } else if (parser.accept(Keyword::v_steps)) {
      node.v_steps = parser.parse_int();
    } else if (parser.accept(Keyword::accuracy)) {
      node.accuracy = parser.parse_float();
    } else if (parser.accept(Keyword::uv_vectors)) {
      std::array<Vec2, 4> uv;
      for (Vec2& corner : uv) {
        corner = parser.parse_uv();
        parser.accept_comma();
      }
      node.uv = uv;
    } else {
      break;
    }
    parser.accept_comma();
  }
  if (!has_type) parser.error("a bicubic_patch needs its type: 'type 0' or 'type 1'");
  node.type = std::min(node.type, 1);
  for (Vec3& point : node.points) {
    point = parser.parse_vector();
    parser.accept_comma();
  }
  return node;
}

}  // namespace durer
