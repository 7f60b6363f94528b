// texture{}: plain, layered, patterned, tiles, material_map (spec/textures.md 15).
#include "parser/parser.h"
#include "parser/statements/loose_texture_items.h"
#include "parser/statements/map_entries.h"
#include "parser/statements/objects.h"
#include "parser/statements/pattern.h"
#include "parser/statements/textures.h"
#include "parser/statements/transformations.h"
#include "tracer/scene/node_memory.h"
#include "tracer/scene/scene.h"

namespace durer {
namespace {

// The same with no_bump_scale, in the textures of its map, too. Of layers only the top one has it.
TexturePtr without_bump_scale(const TexturePtr& texture) {
  if (!texture) return texture;
  auto copy = std::make_shared<TextureNode>(*texture);
  copy->no_bump_scale = true;
  if (texture->normal) {
    auto normal = std::make_shared<NormalNode>(*texture->normal);
    normal->no_bump_scale = true;
    copy->normal = std::move(normal);
  }
  if (texture->kind == TextureNode::Kind::plain) return copy;
  TextureChoice& choice = copy->choice.edit();
  if (choice.map) {
    auto map = std::make_shared<TextureMap>(*choice.map);
    for (auto& entry : map->entries) entry.item = without_bump_scale(entry.item);
    choice.map = std::move(map);
  }
  for (TexturePtr& material : choice.materials) material = without_bump_scale(material);
  return copy;
}

ColorRGBFT with_filter_as_transmit(ColorRGBFT color) {
  color.transmit += color.filter;
  color.filter = 0;
  return color;
}

// Scenes up to language 3.1: what lies above another layer does not filter, it only lets through.
std::shared_ptr<const PigmentNode> with_filter_as_transmit(
    const std::shared_ptr<const PigmentNode>& pigment) {
  if (!pigment) return pigment;
  auto copy = std::make_shared<PigmentNode>(*pigment);
  copy->color = with_filter_as_transmit(pigment->color);
  if (pigment->maps->color_map) {
    auto map = std::make_shared<ColorMap>(*pigment->maps->color_map);
    for (auto& entry : map->entries) entry.item = with_filter_as_transmit(entry.item);
    copy->maps.edit().color_map = std::move(map);
  }
  if (pigment->maps->pigment_map) {
    auto map = std::make_shared<PigmentMap>(*pigment->maps->pigment_map);
    for (auto& entry : map->entries) entry.item = with_filter_as_transmit(entry.item);
    copy->maps.edit().pigment_map = std::move(map);
  }
  return copy;
}

// A texture without a normal gets one that starts from the default's, like a pigment or a finish.
std::shared_ptr<const NormalNode> parse_normal_of(Parser& parser, const TextureNode& texture) {
  return parse_normal(parser,
                      texture.normal ? texture.normal : default_texture(parser)->normal);
}

class TextureReader {
 public:
  explicit TextureReader(Parser& parser) : parser_(parser) {}

  TexturePtr read() {
    const TexturePtr texture = read_parts();
    parser_.check_nesting(texture);
    return no_bump_scale_ ? without_bump_scale(texture) : texture;
  }

 private:
  TexturePtr read_parts() {
    const auto named = parser_.accept_identifier<TextureNode>(ValueKind::texture);
    texture_ = named ? named : default_texture(parser_);
    if (texture_->kind != TextureNode::Kind::plain) {
      while (accept_transform()) {
      }
      return texture_;
    }
    bool any = read_bare_identifiers();
    if (parser_.language_version() < 300) return read_with_loose_items(any || named);
    while (accept_part() || accept_transform()) any = true;
    if (!any && !named) read_patterned();
    return texture_;
  }

  // Before language 3.0 there were no texture_maps yet, and words of all parts could stand here.
  TexturePtr read_with_loose_items(bool any) {
    LooseTextureItems loose(parser_, *texture_);
    while (accept_part() || accept_transform() || loose.accept(texture_) || accept_replacement()) {
      any = true;
    }
    if (!any && parser_.at_any({Keyword::tiles, Keyword::material_map})) {
      read_patterned();
    } else {
      loose.finish(*texture_);
    }
    return texture_;
  }

  // `texture { 0.05 Wood ... }`: the grain came first; nothing of it is left.
  bool accept_replacement() {
    auto named = parser_.accept_identifier<TextureNode>(ValueKind::texture);
    if (!named) return false;
    if (named->kind != TextureNode::Kind::plain) {
      parser_.error("nothing can stand before the name of a texture with a pattern");
    }
    parser_.warning("this texture takes the place of what stands before it");
    texture_ = std::move(named);
    return true;
  }

  TextureNode& edit() {
    auto copy = std::make_shared<TextureNode>(*texture_);
    TextureNode& node = *copy;
    texture_ = std::move(copy);
    return node;
  }

  // Old scenes name a pigment, normal or finish without its braces.
  bool read_bare_identifiers() {
    bool any = false;
    for (;; any = true) {
      if (auto pigment = parser_.accept_identifier<PigmentNode>(ValueKind::pigment)) {
        edit().pigment = std::move(pigment);
      } else if (auto normal = parser_.accept_identifier<NormalNode>(ValueKind::normal)) {
        edit().normal = std::move(normal);
      } else if (auto finish = parser_.accept_identifier<FinishNode>(ValueKind::finish)) {
        edit().finish = std::move(finish);
      } else {
        return any;
      }
    }
  }

  bool accept_part() {
    if (parser_.accept(Keyword::pigment)) {
      auto pigment = parse_pigment(parser_, texture_->pigment);
      edit().pigment = std::move(pigment);
    } else if (parser_.accept(Keyword::normal)) {
      auto normal = parse_normal_of(parser_, *texture_);
      edit().normal = std::move(normal);
    } else if (parser_.accept(Keyword::finish)) {
      auto finish = parse_finish(parser_, texture_->finish);
      edit().finish = std::move(finish);
    } else {
      return false;
    }
    return true;
  }

  bool accept_transform() {
    Transform transform;
    if (accept_transformation(parser_, transform)) {
      texture_ = transformed(texture_, transform, PlainColors::move);
      return true;
    }
    if (parser_.accept(Keyword::no_bump_scale)) {
      no_bump_scale_ = true;
      return true;
    }
    return false;
  }

  void read_patterned() {
    auto node = std::make_shared<TextureNode>();
    node->kind = TextureNode::Kind::patterned;
    TextureChoice& choice = node->choice.edit();
    choice.pattern.position = parser_.position();
    if (parser_.accept(Keyword::tiles)) {
      read_tiles(choice);
      return read_moves(std::move(node));
    } else if (parser_.accept(Keyword::material_map)) {
      node->kind = TextureNode::Kind::material_map;
      read_material_map(choice);
      return read_moves(std::move(node));
    } else if (parser_.accept(Keyword::uv_mapping)) {
      while (parser_.accept(Keyword::uv_mapping)) {
        // Once more changes nothing.
      }
      choice.pattern.kind = PatternKind::uv_mapping;
      auto map = std::make_shared<TextureMap>();
      map->entries.push_back({0, TextureReader(parser_).read()});
      choice.map = std::move(map);
    } else if (parser_.accept(Keyword::object)) {
      choice.pattern.kind = PatternKind::object;
      choice.pattern.frequency = 0;
      parser_.expect_open("object");
      choice.pattern.object = parse_pattern_object(parser_);
      read_list(choice, 2);
      parser_.expect_close("object");
    } else if (accept_pattern(parser_, choice.pattern, PatternUse::texture)) {
      if (const int count = list_length(choice.pattern.kind)) read_list(choice, count);
    } else {
      return;  // an empty texture{} is the default one
    }
    for (;;) {
      if (parser_.accept(Keyword::texture_map)) {
        if (list_length(choice.pattern.kind) > 0) {
          parser_.error("this pattern takes a list, not a texture_map");
        }
        choice.map = parse_texture_map(parser_, choice.pattern.kind == PatternKind::average
                                                    ? MapEntries::weights
                                                    : MapEntries::places);
      } else if (parser_.accept(Keyword::no_bump_scale)) {
        no_bump_scale_ = true;
      } else if (!accept_pattern_modifier(parser_, choice.pattern)) {
        break;
      }
    }
    check_pattern(parser_, choice.pattern);
    if (node->kind == TextureNode::Kind::patterned && !choice.map) {
      parser_.error("a patterned texture needs a texture_map");
    }
    texture_ = std::move(node);
  }

  // Tiles and material maps are moved, but not turbulent.
  void read_moves(TexturePtr texture) {
    texture_ = std::move(texture);
    while (accept_transform()) {
    }
  }

  void read_list(TextureChoice& choice, int count) {
    auto map = std::make_shared<TextureMap>();
    for (int i = 0; i < count; ++i) {
      const float place = static_cast<float>(i);
      if (parser_.accept(Keyword::texture)) {
        map->entries.push_back({place, parse_texture(parser_)});
        parser_.accept_comma();
      } else if (i == 0) {
        return;
      } else {
        map->entries.push_back({place, default_texture(parser_)});
      }
    }
    choice.map = std::move(map);
  }

  // A checker: the first texture at value 1.
  void read_tiles(TextureChoice& choice) {
    parser_.expect_open("tiles");
    if (!parser_.accept(Keyword::texture)) parser_.error_expected("texture");
    const TexturePtr first = parse_layers();
    if (!parser_.accept(Keyword::tile2)) parser_.error_expected("tile2");
    if (!parser_.accept(Keyword::texture)) parser_.error_expected("texture");
    const TexturePtr second = parse_layers();
    parser_.expect_close("tiles");
    choice.pattern.kind = PatternKind::checker;
    choice.pattern.frequency = 0;
    auto map = std::make_shared<TextureMap>();
    map->entries = {{0, second}, {1, first}};
    choice.map = std::move(map);
  }

  TexturePtr parse_layers() {
    TexturePtr texture = layer_texture(parser_, nullptr, parse_texture(parser_));
    while (parser_.accept(Keyword::texture)) {
      texture = layer_texture(parser_, texture, parse_texture(parser_));
    }
    return texture;
  }

  void read_material_map(TextureChoice& choice) {
    parser_.expect_open("material_map");
    choice.pattern.image = parse_image_options(parser_, PatternKind::none);
    while (parser_.accept(Keyword::texture)) choice.materials.push_back(parse_texture(parser_));
    if (choice.materials.empty()) parser_.error("a material_map needs at least one texture");
    parser_.expect_close("material_map");
  }

  Parser& parser_;
  TexturePtr texture_;
  bool no_bump_scale_ = false;  // written in this texture: for all normals in it
};

}  // namespace

TexturePtr default_texture(Parser& parser) {
  TexturePtr& texture = parser.scene().default_texture;
  if (!texture) {
    auto node = std::make_shared<TextureNode>();
    node->pigment = std::make_shared<const PigmentNode>();
    node->finish = std::make_shared<const FinishNode>();
    texture = std::move(node);
  }
  return texture;
}

TexturePtr layer_texture(Parser& parser, const TexturePtr& below, const TexturePtr& top) {
  const bool converts_filter = parser.effective_version() <= 310;
  if (!below && !(converts_filter && top->below)) return top;
  if (below && below->kind != TextureNode::Kind::plain) {
    parser.error("nothing can be layered over a patterned texture");
  }
  if (below && top->kind != TextureNode::Kind::plain) {
    parser.error("a patterned texture cannot be layered over another");
  }
  // The top may be a stack of its own: its bottom comes to lie on `below`.
  auto copy = std::make_shared<TextureNode>(*top);
  copy->below = top->below ? layer_texture(parser, below, top->below) : below;
  if (converts_filter) {
    copy->pigment = with_filter_as_transmit(copy->pigment);
  }
  parser.check_nesting(TexturePtr(copy));
  return copy;
}

TexturePtr parse_texture_part(Parser& parser, Keyword part, const TexturePtr& start) {
  auto texture = make_node<TextureNode>(*start);
  if (part == Keyword::pigment) {
    texture->pigment = parse_pigment(parser, texture->pigment);
  } else if (part == Keyword::normal) {
    texture->normal = parse_normal_of(parser, *texture);
  } else {
    texture->finish = parse_finish(parser, texture->finish);
  }
  return texture;
}

TexturePtr parse_texture(Parser& parser) {
  parser.expect_open("texture");
  TexturePtr texture = TextureReader(parser).read();
  parser.expect_close("texture");
  return texture;
}

TexturePtr parse_texture_entry(Parser& parser) { return TextureReader(parser).read(); }

}  // namespace durer
