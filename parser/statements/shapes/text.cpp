// text (spec/geometry.md 12.13).
#include "parser/font_replacement.h"
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"
#include "tracer/shapes/text.h"

namespace durer {

namespace {

// The fonts that every installation has beside its include files.
const char* internal_font_file(int number) {
  switch (number) {
    case 1: return "timrom.ttf";
    case 2: return "cyrvetic.ttf";
    case 3: return "crystal.ttf";
    default: return "povlogo.ttf";
  }
}

}  // namespace

ShapeNode parse_text(Parser& parser) {
  TextNode node;
  std::string font_name;
  if (parser.accept(Keyword::ttf)) {
    font_name = parser.parse_path_string();
    node.font = parser.find_file(font_name, FileType::font);
    if (node.font.empty()) {
      node.font = replacement_font(font_name);
      if (node.font.empty()) {
        parser.error("the font '" + font_name + "' is not found, nor any other font");
      }
      parser.warning("the font '" + font_name + "' is not found; '" + node.font +
                     "' is used for it");
    }
  } else if (parser.accept(Keyword::internal)) {
    font_name = internal_font_file(parser.parse_int());
    node.font = parser.find_file(font_name, FileType::font);
    if (node.font.empty()) parser.error("the internal font '" + font_name + "' is not found");
  } else {
    parser.error_expected("ttf or internal");
  }
  node.unicode = parser.font_is_unicode(font_name, node.font);
  try {
    check_font(node.font);
  } catch (const std::runtime_error& failure) {
    parser.error(failure.what());
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
