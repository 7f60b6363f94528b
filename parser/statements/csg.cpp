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
  builder.set_csg(std::move(csg));
  return builder.finish(what);
}

// Its members first, then what acts on all of them.
ObjectPtr parse_light_group(Parser& parser) {
  parser.expect_open("light_group");
  ObjectBuilder builder(parser);
  CsgNode csg;
  csg.is_light_group = true;
  csg.global_lights = false;
  while (ObjectPtr child = parse_object(parser)) csg.children.push_back(std::move(child));
  Transform transform;
  for (;;) {
    if (accept_transformation(parser, transform)) {
      builder.add(transform);
    } else if (parser.accept(Keyword::global_lights)) {
      csg.global_lights = parser.parse_optional_float(1) > 0.5;
    } else if (parser.accept(Keyword::photons)) {
      builder.add(SetPhotons{parse_object_photons(parser)});
    } else {
      break;
    }
  }
  builder.set_csg(std::move(csg));
  return builder.close("light_group");
}

}  // namespace durer
