// text (spec/geometry.md 12.13).
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"

namespace durer {

ShapeNode parse_text(Parser& parser) {
  TextNode node;
  if (parser.accept(Keyword::ttf)) {
    const std::string name = parser.parse_path_string();
    node.font = parser.find_file(name, FileType::font);
    if (node.font.empty()) parser.error("the font '" + name + "' is not found");
  } else if (parser.accept(Keyword::internal)) {
    node.internal_font = parser.parse_int();
  } else {
    parser.error_expected("ttf or internal");
  }
  parser.accept_comma();
  node.text = parser.parse_string();
  parser.accept_comma();
  node.depth = parser.parse_float();
  parser.accept_comma();
  node.offset = parser.parse_vector();
  return node;
}

}  // namespace durer
