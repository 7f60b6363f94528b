// height_field (spec/geometry.md 12.14).
#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"
#include "parser/statements/textures.h"

namespace durer {

ShapeNode parse_height_field(Parser& parser) {
  HeightFieldNode node;
  node.image = parse_image_file(parser, ImageUse::height_field);
  for (;;) {
    if (parser.accept(Keyword::water_level)) {
      node.water_level = parser.parse_float();
      if (parser.language_version() < 200) node.water_level /= 256;
    } else if (parser.accept(Keyword::smooth)) {
      node.smooth = true;
    } else {
      break;
    }
  }
  return node;
}

}  // namespace durer
