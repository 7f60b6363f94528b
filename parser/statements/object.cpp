// Which statement makes which object.
#include "parser/parser.h"
#include "parser/statements/objects.h"
#include "parser/statements/transformations.h"

namespace durer {
namespace {

ObjectPtr parse_copy(Parser& parser) {
  parser.expect_open("object");
  ObjectBuilder builder(parser);
  if (!builder.accept_base()) {
    // object{ sphere{...} ... }: the inner statement is what this one copies.
    const ObjectPtr inner = parse_object(parser);
    if (!inner) parser.error_expected("an object");
    ObjectBuilder wrapper(parser, inner);
    return wrapper.finish("object");
  }
  return builder.finish("object");
}

ObjectPtr parse_shape(Parser& parser, const ShapeEntry& entry) {
  parser.next();
  parser.expect_open(entry.name);
  ObjectBuilder builder(parser);
  if (!builder.accept_base()) builder.set_shape(entry.parse(parser));
  return builder.finish(entry.name);
}

}  // namespace

ObjectPtr parse_object(Parser& parser) {
  if (const auto named = parser.accept_identifier<ObjectNode>(ValueKind::object)) return named;
  const Token& token = parser.peek();
  if (token.kind != TokenKind::keyword) return nullptr;
  const Keyword keyword = token.keyword;
  if (const ShapeEntry* shape = find_shape(keyword)) return parse_shape(parser, *shape);
  switch (keyword) {
    case Keyword::object:
      parser.next();
      return parse_copy(parser);
    case Keyword::union_:
      parser.next();
      return parse_csg(parser, CsgKind::union_, "union");
    case Keyword::composite:
      parser.next();
      parser.warning("'composite' is an old word for 'union'");
      return parse_csg(parser, CsgKind::union_, "composite");
    case Keyword::merge:
      parser.next();
      return parse_csg(parser, CsgKind::merge, "merge");
    case Keyword::intersection:
      parser.next();
      return parse_csg(parser, CsgKind::intersection, "intersection");
    case Keyword::difference:
      parser.next();
      return parse_csg(parser, CsgKind::difference, "difference");
    case Keyword::light_source:
      parser.next();
      return parse_light_source(parser);
    case Keyword::light_group:
      parser.next();
      return parse_light_group(parser);
    default:
      return nullptr;
  }
}

ObjectPtr require_object(Parser& parser) {
  ObjectPtr object = parse_object(parser);
  if (!object) parser.error_expected("an object");
  return object;
}

ObjectPtr parse_pattern_object(Parser& parser) {
  ObjectPtr object = require_object(parser);
  for (Transform transform; accept_transformation(parser, transform); transform = {}) {
    object = with_modifier(std::move(object), Rare<Transform>(transform));
  }
  return object;
}

}  // namespace durer
