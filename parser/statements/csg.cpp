// union, merge, intersection, difference, light_group (spec/language.md 24, spec/geometry.md 6).
#include "parser/parser.h"
#include "parser/statements/objects.h"
#include "parser/statements/textures.h"
#include "parser/statements/transformations.h"

namespace durer {
namespace {

bool is_light(const ObjectNode& object) {
  return std::holds_alternative<std::shared_ptr<const LightNode>>(shape_of(object));
}

}  // namespace

ObjectPtr parse_csg(Parser& parser, CsgKind kind, const char* what) {
  parser.expect_open(what);
  ObjectBuilder builder(parser);
  if (builder.accept_base()) return builder.finish(what);
  CsgNode csg;
  csg.kind = kind;
  while (ObjectPtr child = parse_object(parser)) {
    const bool cuts = kind == CsgKind::intersection || kind == CsgKind::difference;
    if (cuts && !is_light(*child) && !is_solid(*child)) {
      parser.warning(std::string("a patch has no inside and does not belong in a ") + what);
    }
    csg.children.push_back(std::move(child));
    parser.check_limit(csg.children.size(), parser.options().limits.max_array_elements,
                       "objects in one CSG");
  }
  if (csg.children.size() < 2) {
    parser.warning(std::string("a ") + what + " should have at least two objects");
  }
  builder.set_shape(std::move(csg));
  return builder.finish(what);
}

ObjectPtr parse_light_group(Parser& parser) {
  parser.expect_open("light_group");
  CsgNode csg;
  csg.is_light_group = true;
  csg.global_lights = false;
  auto node = std::make_shared<ObjectNode>();
  node->position = parser.position();
  Transform transform;
  for (;;) {
    if (ObjectPtr child = parse_object(parser)) {
      csg.children.push_back(std::move(child));
    } else if (accept_transformation(parser, transform)) {
      node->modifiers.push_back(transform);
    } else if (parser.accept(Keyword::global_lights)) {
      csg.global_lights = parser.parse_optional_float(1) > 0.5;
    } else if (parser.accept(Keyword::photons)) {
      node->modifiers.push_back(SetPhotons{parse_object_photons(parser)});
    } else {
      break;
    }
  }
  parser.expect_close("light_group");
  node->shape = std::make_shared<const ShapeNode>(std::move(csg));
  return node;
}

}  // namespace durer
