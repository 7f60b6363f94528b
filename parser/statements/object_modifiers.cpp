// What may follow an object's parameters (spec/language.md 25).
#include <algorithm>
#include <unordered_set>

#include "parser/parser.h"
#include "parser/statements/objects.h"
#include "parser/statements/textures.h"
#include "parser/statements/transformations.h"
#include "tracer/scene/node_memory.h"

namespace durer {
namespace {

// What is copied deeper than this is a mistake in a loop.
constexpr int kMostCopyLevels = 10000;

// What bounded_by and clipped_by said so far, in this statement and in those that it copies.
struct ClipState {
  bool has_bounds = false, has_clips = false, linked = false;
};

ClipState clip_state(const ObjectNode& object) {
  ClipState state;
  for (const ObjectNode* node = &object; node; node = node->base.get()) {
    for (const Modifier& modifier : node->modifiers) {
      state.has_bounds |= std::holds_alternative<AddBounds>(modifier);
      state.has_clips |= std::holds_alternative<AddClips>(modifier);
      state.linked |= std::holds_alternative<ShareBoundsAsClips>(modifier) ||
                      std::holds_alternative<ShareClipsAsBounds>(modifier);
    }
  }
  return state;
}

}  // namespace

ObjectBuilder::ObjectBuilder(Parser& parser)
    : parser_(parser), node_(make_node<ObjectNode>()) {
  node_->position = parser.position();
}

ObjectBuilder::ObjectBuilder(Parser& parser, const ObjectPtr& base) : ObjectBuilder(parser) {
  set_base(base);
}

bool ObjectBuilder::accept_base() {
  const auto base = parser_.accept_identifier<ObjectNode>(ValueKind::object);
  if (base) set_base(base);
  return base != nullptr;
}

void ObjectBuilder::set_base(const ObjectPtr& base) {
  node_->base = base;
  node_->copy_depth = base->copy_depth + 1;
  if (node_->copy_depth > kMostCopyLevels) {
    parser_.error("this object is a copy of a copy of a copy ...: the limit is " +
                  std::to_string(kMostCopyLevels) + " levels");
  }
}

void ObjectBuilder::set_shape(ShapeNode shape) {
  node_->shape = make_node<const ShapeNode>(std::move(shape));
}

void ObjectBuilder::set_csg(CsgNode csg) {
  set_shape(std::move(csg));
}

ObjectPtr ObjectBuilder::finish(const char* what) {
  while (accept_modifier()) {
  }
  if (interior_texture_given_ && !resolve_textures(*node_).texture) {
    parser_.error("an interior_texture needs a texture on the outside, too");
  }
  return close(what);
}

ObjectPtr ObjectBuilder::close(const char* what) {
  parser_.expect_close(what);
  parser_.check_nesting(*node_);
  return std::move(node_);
}

bool ObjectBuilder::accept_modifier() {
  const Token& token = parser_.peek();
  if (token.kind == TokenKind::keyword) {
    const Keyword keyword = token.keyword;
    switch (keyword) {
      case Keyword::translate:
      case Keyword::rotate:
      case Keyword::scale:
      case Keyword::matrix:
      case Keyword::transform: {
        Transform transform;
        accept_transformation(parser_, transform);
        add(transform);
        return true;
      }
      case Keyword::bounded_by:
      case Keyword::clipped_by:
        parser_.next();
        parse_clips(keyword == Keyword::bounded_by);
        return true;
      case Keyword::photons:
        parser_.next();
        add(SetPhotons{parse_object_photons(parser_)});
        return true;
      case Keyword::radiosity:
        parser_.next();
        add(SetRadiosityImportance{parse_radiosity_importance(parser_)});
        return true;
      case Keyword::dtag:
        parser_.next();
        parser_.parse_string();
        return true;
      default:
        if (accept_texture_item(keyword) || accept_flag(keyword)) return true;
        break;
    }
  }
  if (!parser_.at_color_start()) return false;
  parser_.parse_color();
  parser_.warning("a colour belongs into the texture; this one is ignored");
  return true;
}

void ObjectBuilder::set_texture(TexturePtr texture) { add(SetTexture{std::move(texture)}); }

// The texture that `pigment{}` and its like change: the object's, or a copy of the default one.
TexturePtr ObjectBuilder::texture_to_modify() {
  if (node_->modifiers.empty() && !node_->base) return default_texture(parser_);
  const TexturePtr texture = resolve_textures(*node_, PlainColors::move).texture;
  if (texture && texture->kind != TextureNode::Kind::plain) {
    parser_.error("a patterned texture cannot be changed by a pigment, normal or finish here");
  }
  return texture ? texture : default_texture(parser_);
}

bool ObjectBuilder::accept_texture_item(Keyword keyword) {
  switch (keyword) {
    case Keyword::texture: {
      parser_.next();
      const TexturePtr top = parse_texture(parser_);
      const TexturePtr below = resolve_textures(*node_).texture;
      set_texture(layer_texture(parser_, below, top));
      return true;
    }
    case Keyword::pigment:
    case Keyword::normal:
    case Keyword::finish: {
      parser_.next();
      set_texture(parse_texture_part(parser_, keyword, texture_to_modify()));
      return true;
    }
    case Keyword::interior_texture: {
      parser_.next();
      const TexturePtr top = parse_texture(parser_);
      const TexturePtr below = resolve_textures(*node_).interior_texture;
      add(SetInteriorTexture{layer_texture(parser_, below, top)});
      interior_texture_given_ = true;
      return true;
    }
    case Keyword::interior:
      parser_.next();
      add(SetInterior{parse_interior(parser_, resolve_textures(*node_).interior)});
      return true;
    case Keyword::material: {
      parser_.next();
      // It adds to what the object has: another layer, further items of the interior.
      const ResolvedTextures surface = resolve_textures(*node_, PlainColors::move);
      const auto material = parse_material(
          parser_, {surface.texture, surface.interior_texture, surface.interior});
      if (material->texture) set_texture(material->texture);
      if (material->interior_texture) {
        add(SetInteriorTexture{material->interior_texture});
        interior_texture_given_ = true;
      }
      if (material->interior != surface.interior) add(SetInterior{material->interior});
      return true;
    }
    case Keyword::uv_mapping:
      parser_.next();
      if (resolve_textures(*node_).texture) {
        parser_.error("uv_mapping must come before the texture");
      }
      add(SetFlag{ObjectFlag::uv_mapping, true});
      return true;
    default:
      return false;
  }
}

bool ObjectBuilder::accept_flag(Keyword keyword) {
  const auto add_switch = [&](ObjectFlag flag) {
    parser_.next();
    add(SetFlag{flag, parser_.parse_optional_switch()});
    return true;
  };
  switch (keyword) {
    case Keyword::hollow: return add_switch(ObjectFlag::hollow);
    case Keyword::double_illuminate: return add_switch(ObjectFlag::double_illuminate);
    case Keyword::no_image: return add_switch(ObjectFlag::no_image);
    case Keyword::no_reflection: return add_switch(ObjectFlag::no_reflection);
    case Keyword::no_radiosity: return add_switch(ObjectFlag::no_radiosity);
    case Keyword::no_shadow:
      parser_.next();
      add(SetFlag{ObjectFlag::no_shadow, true});
      return true;
    case Keyword::inverse:
      parser_.next();
      if (!is_solid(*node_)) {
        parser_.warning("this object is a patch without an inside: inverse has no effect");
      }
      add(SetFlag{ObjectFlag::inverse, true});
      return true;
    case Keyword::sturm:
    case Keyword::hierarchy:
      parser_.next();
      check_supported(keyword);
      add(SetFlag{keyword == Keyword::sturm ? ObjectFlag::sturm : ObjectFlag::hierarchy,
                  parser_.parse_optional_switch()});
      return true;
    case Keyword::split_union: {
      parser_.next();
      const auto* csg = std::get_if<CsgNode>(&shape_of(*node_));
      if (!csg || (csg->kind != CsgKind::union_ && csg->kind != CsgKind::merge)) {
        parser_.error("split_union belongs to unions only");
      }
      add(SetFlag{ObjectFlag::split_union, parser_.parse_float() > 0});
      return true;
    }
    case Keyword::cutaway_textures: {
      parser_.next();
      const auto* csg = std::get_if<CsgNode>(&shape_of(*node_));
      if (!csg || (csg->kind != CsgKind::intersection && csg->kind != CsgKind::difference)) {
        parser_.error("cutaway_textures belongs to intersections and differences only");
      }
      add(SetFlag{ObjectFlag::cutaway_textures, true});
      return true;
    }
    default:
      return false;
  }
}

// sturm and hierarchy mean something to a few shapes only (spec/geometry.md 16.3).
void ObjectBuilder::check_supported(Keyword keyword) {
  const ShapeNode& shape = shape_of(*node_);
  const auto is = [&]<typename... Kinds>() { return (std::holds_alternative<Kinds>(shape) || ...); };
  const bool ok =
      keyword == Keyword::sturm
          ? is.operator()<TorusNode, OvusNode, PolyNode, LatheNode, SorNode, PrismNode, BlobNode,
                          SphereSweepNode>()
          : is.operator()<BlobNode, HeightFieldNode, Rare<MeshNode>>();
  if (!ok) {
    parser_.error(std::string("'") + (keyword == Keyword::sturm ? "sturm" : "hierarchy") +
                  "' has no meaning for this object");
  }
}

void ObjectBuilder::parse_clips(bool bounds) {
  const char* what = bounds ? "bounded_by" : "clipped_by";
  parser_.expect_open(what);
  if (parser_.accept(bounds ? Keyword::clipped_by : Keyword::bounded_by)) {
    link_clips(bounds);
    parser_.expect_close(what);
    return;
  }
  if (clip_state(*node_).linked) {
    parser_.error(std::string(what) +
                  " cannot be extended once the object uses the same list for both");
  }
  std::vector<ObjectPtr> objects;
  while (ObjectPtr object = parse_object(parser_)) {
    if (!is_solid(*object) || is_textured(*object)) {
      parser_.error(std::string(what) + " takes solid objects without textures only");
    }
    objects.push_back(std::move(object));
  }
  if (objects.empty()) parser_.error_expected("an object");
  Transform all = parse_transformations(parser_);
  if (!all.is_identity()) {
    for (ObjectPtr& object : objects) object = with_modifier(std::move(object), all);
  }
  if (bounds) {
    add(AddBounds{std::move(objects)});
  } else {
    add(AddClips{std::move(objects)});
  }
  parser_.expect_close(what);
}

// bounded_by{clipped_by} and clipped_by{bounded_by}: one list serves as both.
void ObjectBuilder::link_clips(bool bounds) {
  const ClipState state = clip_state(*node_);
  if (bounds ? state.has_bounds : state.has_clips) {
    parser_.error(bounds ? "the object has bounds already: clipped_by cannot serve as them, too"
                         : "the object has clips already: bounded_by cannot serve as them, too");
  }
  // An empty list is not shared.
  if (bounds ? !state.has_clips : !state.has_bounds) return;
  if (bounds) {
    add(ShareClipsAsBounds{});
  } else {
    add(ShareBoundsAsClips{});
  }
}

ObjectPtr with_modifier(ObjectPtr object, Modifier modifier) {
  if (object.use_count() == 1) {
    std::const_pointer_cast<ObjectNode>(object)->modifiers.push_back(std::move(modifier));
    return object;
  }
  auto copy = std::make_shared<ObjectNode>();
  copy->position = object->position;
  copy->parts = object->parts;
  copy->csg_depth = object->csg_depth;
  copy->copy_depth = object->copy_depth + 1;
  copy->base = std::move(object);
  copy->modifiers.push_back(std::move(modifier));
  return copy;
}

namespace {

// `known`: CSG that was looked at already, without textures here and solid below; copies of copies
// would double the work each time.
bool is_textured(const ObjectNode& object, std::unordered_set<const CsgNode*>& known) {
  if (resolve_textures(object).texture) return true;
  const auto* csg = std::get_if<CsgNode>(&shape_of(object));
  return csg && known.insert(csg).second &&
         std::any_of(csg->children.begin(), csg->children.end(),
                     [&](const ObjectPtr& child) { return is_textured(*child, known); });
}

bool is_solid(const ObjectNode& object, std::unordered_set<const CsgNode*>& known) {
  const ShapeNode& shape = shape_of(object);
  if (const auto* mesh = std::get_if<Rare<MeshNode>>(&shape)) return mesh->get().inside_vector.has_value();
  if (const auto* csg = std::get_if<CsgNode>(&shape)) {
    if (known.contains(csg)) return true;
    for (const ObjectPtr& child : csg->children) {
      if (!is_solid(*child, known) && !std::holds_alternative<std::shared_ptr<const LightNode>>(
                                   shape_of(*child))) {
        return false;
      }
    }
    known.insert(csg);
    return true;
  }
  return !std::holds_alternative<TriangleNode>(shape) &&
         !std::holds_alternative<Rare<SmoothTriangleNode>>(shape) &&
         !std::holds_alternative<Rare<BicubicPatchNode>>(shape) &&
         !std::holds_alternative<Rare<ParametricNode>>(shape) &&
         !std::holds_alternative<std::shared_ptr<const LightNode>>(shape);
}

}  // namespace

bool is_textured(const ObjectNode& object) {
  std::unordered_set<const CsgNode*> known;
  return is_textured(object, known);
}

bool is_solid(const ObjectNode& object) {
  std::unordered_set<const CsgNode*> known;
  return is_solid(object, known);
}

}  // namespace durer
