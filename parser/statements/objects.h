// Objects: shapes, CSG, lights, and what may follow their parameters (spec/language.md 24, 25).
#pragma once

#include <memory>

#include "parser/keyword.h"
#include "tracer/scene/light.h"
#include "tracer/scene/object.h"

namespace durer {

class Parser;

// An object statement, `object{...}` or a bare object identifier. Null, nothing consumed, if the
// next token starts none.
ObjectPtr parse_object(Parser& parser);
// The same; an error if there is none.
ObjectPtr require_object(Parser& parser);

// An object under construction: its node, and the textures in force so far, which `pigment{}` and
// the like modify in place.
class ObjectBuilder {
 public:
  explicit ObjectBuilder(Parser& parser);
  // Copies the given object.
  ObjectBuilder(Parser& parser, const ObjectPtr& base);

  // The first item of any object's braces may be another object, which this one then copies.
  bool accept_base();
  void set_shape(ShapeNode shape);
  void add(Modifier modifier) { node_->modifiers.push_back(std::move(modifier)); }
  // Everything of spec/language.md 25, up to the closing brace, which is consumed.
  ObjectPtr finish(const char* what);

 private:
  bool accept_modifier();
  bool accept_flag();
  bool accept_texture_item();
  void set_texture(TexturePtr texture);
  TexturePtr texture_to_modify();
  void parse_clips(bool bounds);
  void check_supported(Keyword keyword);

  Parser& parser_;
  std::shared_ptr<ObjectNode> node_;
  ResolvedTextures textures_;
};

// True if a ray's side of it can be told: not a triangle, disc-like patch or open mesh.
bool is_solid(const ObjectNode& object);

// The statements behind the keywords; the keyword has been consumed.
ObjectPtr parse_light_source(Parser& parser);
ObjectPtr parse_csg(Parser& parser, CsgKind kind, const char* what);
ObjectPtr parse_light_group(Parser& parser);

// Parameters of one shape, after `{`. Each is defined in shapes/ and listed in shape_table.cpp.
using ShapeParser = ShapeNode (*)(Parser& parser);
struct ShapeEntry {
  Keyword keyword;
  const char* name;
  ShapeParser parse;
};
const ShapeEntry* find_shape(Keyword keyword);

}  // namespace durer
