// blob (spec/geometry.md 12.7).
#include <cmath>

#include "parser/parser.h"
#include "parser/statements/shapes/shape_parsers.h"
#include "parser/statements/textures.h"
#include "parser/statements/transformations.h"

namespace durer {
namespace {

double parse_strength(Parser& parser) {
  parser.accept_comma();
  parser.accept(Keyword::strength);
  return parser.parse_float();
}

// What leaves a sphere a sphere moves its centre and radius; its reported box depends on it.
bool moves_sphere(Keyword keyword, const Transform& transform) {
  if (keyword == Keyword::translate || keyword == Keyword::rotate) return true;
  const Vec3 by = transform.direction({1, 1, 1});
  return keyword == Keyword::scale && by.x == by.y && by.y == by.z;
}

void move_component(BlobComponent& component, Keyword keyword, const Transform& transform) {
  if (component.is_cylinder || !component.transform.is_identity() ||
      !moves_sphere(keyword, transform)) {
    component.transform = component.transform.then(transform);
    return;
  }
  component.center = transform.point(component.center);
  if (keyword == Keyword::scale) component.radius *= std::abs(transform.direction({1, 0, 0}).x);
}

// Transformations and textures of one component, up to its brace.
void parse_component_modifiers(Parser& parser, BlobComponent& component, const char* what) {
  Transform transform;
  for (;;) {
    const Token& token = parser.peek();
    const Keyword keyword = token.kind == TokenKind::keyword ? token.keyword : Keyword::sphere;
    if (accept_transformation(parser, transform)) {
      move_component(component, keyword, transform);
      component.texture = transformed(component.texture, transform);
    } else if (parser.accept(Keyword::texture)) {
      const TexturePtr top = parse_texture(parser);
      component.texture = layer_texture(parser, component.texture, top);
    } else if (parser.at_any({Keyword::pigment, Keyword::normal, Keyword::finish})) {
      const Keyword part = parser.next().keyword;
      component.texture = parse_texture_part(
          parser, part, component.texture ? component.texture : default_texture(parser));
    } else {
      break;
    }
  }
  parser.expect_close(what);
}

}  // namespace

ShapeNode parse_blob(Parser& parser) {
  BlobNode node;
  for (;;) {
    if (parser.accept(Keyword::threshold)) {
      node.threshold = parser.parse_float();
    } else if (parser.accept(Keyword::sphere)) {
      BlobComponent component;
      parser.expect_open("sphere");
      component.center = parser.parse_vector();
      parser.accept_comma();
      component.radius = parser.parse_float();
      component.strength = parse_strength(parser);
      parse_component_modifiers(parser, component, "sphere");
      node.components.push_back(std::move(component));
    } else if (parser.accept(Keyword::cylinder)) {
      BlobComponent component;
      component.is_cylinder = true;
      parser.expect_open("cylinder");
      component.center = parser.parse_vector();
      parser.accept_comma();
      component.apex = parser.parse_vector();
      parser.accept_comma();
      component.radius = parser.parse_float();
      component.strength = parse_strength(parser);
      if (component.center == component.apex) {
        parser.error("the two ends of a blob's cylinder are the same point");
      }
      parse_component_modifiers(parser, component, "cylinder");
      node.components.push_back(std::move(component));
    } else if (parser.accept(Keyword::component)) {
      BlobComponent component;
      component.strength = parser.parse_float();
      parser.accept_comma();
      component.radius = parser.parse_float();
      parser.accept_comma();
      component.center = parser.parse_vector();
      node.components.push_back(std::move(component));
    } else {
      break;
    }
  }
  if (node.components.empty()) parser.error("a blob needs at least one component");
  return node;
}

}  // namespace durer
