// bicubic_patch (spec/geometry.md 13.6).
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {

ShapeNode parse_bicubic_patch(Parser& parser) {
  BicubicPatchNode node;
  // The oldest form has the type as a bare number.
  if (parser.language_version() < 150 && parser.at_expression()) {
    node.type = parser.parse_int();
    parser.accept_comma();
  }
  for (;;) {
    if (parser.accept(Keyword::type)) {
      node.type = parser.parse_int();
      if (node.type < 0 || node.type > 1) parser.error("a bicubic_patch is of type 0 or 1");
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
  for (Vec3& point : node.points) {
    point = parser.parse_vector();
    parser.accept_comma();
  }
  return node;
}

}  // namespace durer
