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
// What an object pattern asks about, behind its brace: an object, perhaps moved there.
ObjectPtr parse_pattern_object(Parser& parser);

// An object under construction: its node, whose modifiers tell which textures are in force.
class ObjectBuilder {
 public:
  explicit ObjectBuilder(Parser& parser);
  // Copies the given object.
  ObjectBuilder(Parser& parser, const ObjectPtr& base);

  // The first item of any object's braces may be another object, which this one then copies.
  bool accept_base();
  void set_shape(ShapeNode shape);
  // A CSG of these members: counts the levels.
  void set_csg(CsgNode csg);
  void add(Modifier modifier) { node_->modifiers.push_back(std::move(modifier)); }
  // Everything of spec/language.md 25, up to the closing brace, which is consumed.
  ObjectPtr finish(const char* what);
  // The closing brace alone.
  ObjectPtr close(const char* what);

 private:
  void set_base(const ObjectPtr& base);
  bool accept_modifier();
  bool accept_flag(Keyword keyword);
  bool accept_texture_item(Keyword keyword);
  void set_texture(TexturePtr texture);
  TexturePtr texture_to_modify();
  void parse_clips(bool bounds);
  void link_clips(bool bounds);
  void check_supported(Keyword keyword);

  Parser& parser_;
  std::shared_ptr<ObjectNode> node_;
  bool interior_texture_given_ = false;
};

// True unless it is a patch (spec/geometry.md 13), which has no inside, or holds one.
bool is_solid(const ObjectNode& object);
// True if the object, or a member of it, has a texture of its own.
bool is_textured(const ObjectNode& object);
// A copy of the object with one more modifier. The object itself gets it if nobody else holds it.
ObjectPtr with_modifier(ObjectPtr object, Modifier modifier);

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
