// pigment{} and density{}, their lists and maps (spec/textures.md 11).
#include "parser/parser.h"
#include "parser/statements/map_entries.h"
#include "parser/statements/objects.h"
#include "parser/statements/pattern.h"
#include "parser/statements/textures.h"
#include "tracer/scene/node_memory.h"

namespace durer {
namespace {

class PigmentReader {
 public:
  PigmentReader(Parser& parser, PigmentNode& node, PatternUse use)
      : parser_(parser), node_(node), use_(use) {}

  void read() {
    if (parser_.accept(Keyword::uv_mapping)) {
      while (parser_.accept(Keyword::uv_mapping)) {
        // Once more changes nothing.
      }
      if (use_ == PatternUse::density) parser_.error("uv_mapping has no meaning in a density");
      read_uv();
      return;
    }
    read_start();
    // Most pigments are a colour and nothing else: their pattern is not touched.
    while (parser_.peek().kind == TokenKind::keyword &&
           (accept_map() || accept_quick_color() || accept_no_bump_scale() ||
            accept_pattern_modifier(parser_, node_.pattern.edit()))) {
    }
    check_pattern(parser_, *node_.pattern);
    if (node_.is_unspecified && node_.pattern->kind == PatternKind::none &&
        use_ == PatternUse::pigment && !started_from_identifier_ && !parser_.in_default_block) {
      parser_.warning("this pigment has no colour and no pattern: it is black");
    }
    if (node_.pattern->kind == PatternKind::average && !node_.maps->pigment_map) {
      parser_.error("average needs a map");
    }
  }

  void set_started_from_identifier() { started_from_identifier_ = true; }

 private:
  bool is_density() const { return use_ == PatternUse::density; }

  // Everything after uv_mapping belongs to a new pigment at (u, v, 0), the only entry of a map.
  void read_uv() {
    auto inner = std::make_shared<PigmentNode>();
    PigmentReader(parser_, *inner, use_).read();
    node_ = PigmentNode{};
    node_.is_unspecified = false;
    node_.quick_color = inner->quick_color;
    node_.pattern.edit().kind = PatternKind::uv_mapping;
    auto map = std::make_shared<PigmentMap>();
    map->entries.push_back({0, std::move(inner)});
    node_.maps = PigmentMaps{.pigment_map = std::move(map)};
  }

  // A colour or a pattern with its list.
  void read_start() {
    if (parser_.at_color_start()) {
      node_.color = parser_.parse_color();
      // What the pattern has besides its kind waits for a pattern that a later pigment{} may give.
      if (node_.pattern->kind != PatternKind::none) node_.pattern.edit().kind = PatternKind::none;
      node_.is_unspecified = false;
      return;
    }
    if (parser_.peek().kind != TokenKind::keyword) return;
    if (parser_.accept(Keyword::object)) {
      node_.pattern.edit().kind = PatternKind::object;
      node_.pattern.edit().frequency = 0;
      parser_.expect_open("object");
      node_.pattern.edit().object = parse_pattern_object(parser_);
      read_list(2);
      parser_.expect_close("object");
    } else if (accept_pattern(parser_, node_.pattern.edit(), use_)) {
      if (const int count = list_length(node_.pattern->kind)) read_list(count);
    } else {
      return;
    }
    node_.is_unspecified = false;
  }

  void read_list(int count) {
    const Keyword word = is_density() ? Keyword::density : Keyword::pigment;
    if (parser_.at(word)) {
      auto map = std::make_shared<PigmentMap>();
      while (static_cast<int>(map->entries.size()) < count && parser_.accept(word)) {
        const float place = static_cast<float>(map->entries.size());
        map->entries.push_back(
            {place, is_density() ? parse_density(parser_)
                                 : parse_pigment(parser_, default_texture(parser_)->pigment)});
        parser_.accept_comma();
      }
      while (static_cast<int>(map->entries.size()) < count) {
        const float place = static_cast<float>(map->entries.size());
        map->entries.push_back({place, default_texture(parser_)->pigment});
      }
      node_.maps = PigmentMaps{.pigment_map = std::move(map)};
      return;
    }
    node_.maps = PigmentMaps{.color_map = parse_color_list(parser_, *node_.pattern)};
  }

  bool accept_map() {
    if (parser_.accept(Keyword::color_map)) {
      check_map("color_map");
      if (node_.pattern->kind == PatternKind::average) {
        parser_.error("average takes no colour_map");
      }
      node_.maps = PigmentMaps{.color_map = parse_color_map(parser_)};
    } else if (parser_.accept(is_density() ? Keyword::density_map : Keyword::pigment_map)) {
      check_map(is_density() ? "density_map" : "pigment_map");
      const MapEntries entries = node_.pattern->kind == PatternKind::average ? MapEntries::weights
                                                                             : MapEntries::places;
      node_.maps = PigmentMaps{.pigment_map = is_density() ? parse_density_map(parser_, entries)
                                                           : parse_pigment_map(parser_, entries)};
    } else {
      return false;
    }
    return true;
  }

  void check_map(const char* what) {
    if (list_length(node_.pattern->kind) > 0) {
      parser_.error(std::string("this pattern takes a list, not a ") + what);
    }
    if (node_.pattern->kind == PatternKind::image_map) {
      parser_.error(std::string("an image_map takes no ") + what);
    }
    if (node_.pattern->kind == PatternKind::none && !node_.is_unspecified) {
      parser_.error(std::string("a solid colour takes no ") + what);
    }
  }

  bool accept_quick_color() {
    if (!parser_.accept(Keyword::quick_color)) return false;
    node_.quick_color = std::optional(parser_.parse_color());
    return true;
  }

  // A pattern modifier that says nothing about colours.
  bool accept_no_bump_scale() { return parser_.accept(Keyword::no_bump_scale); }

  Parser& parser_;
  PigmentNode& node_;
  PatternUse use_;
  bool started_from_identifier_ = false;
};

std::shared_ptr<const PigmentNode> read_contents(Parser& parser,
                                                 const std::shared_ptr<const PigmentNode>& start,
                                                 PatternUse use) {
  const ValueKind kind = use == PatternUse::density ? ValueKind::density : ValueKind::pigment;
  const auto named = parser.accept_identifier<PigmentNode>(kind);
  auto node = make_node<PigmentNode>(named ? *named : *start);
  PigmentReader reader(parser, *node, use);
  if (named) reader.set_started_from_identifier();
  reader.read();
  parser.check_nesting(std::shared_ptr<const PigmentNode>(node));
  return node;
}

std::shared_ptr<const PigmentNode> default_density() {
  auto node = std::make_shared<PigmentNode>();
  node->color = {1, 1, 1, 0, 0};
  return node;
}

}  // namespace

std::shared_ptr<const PigmentNode> parse_pigment(Parser& parser,
                                                 const std::shared_ptr<const PigmentNode>& start) {
  parser.expect_open("pigment");
  auto node = read_contents(parser, start, PatternUse::pigment);
  parser.expect_close("pigment");
  return node;
}

std::shared_ptr<const PigmentNode> parse_pigment_entry(Parser& parser) {
  return read_contents(parser, default_texture(parser)->pigment, PatternUse::pigment);
}

std::shared_ptr<const PigmentNode> parse_density(Parser& parser) {
  parser.expect_open("density");
  auto node = read_contents(parser, default_density(), PatternUse::density);
  parser.expect_close("density");
  return node;
}

std::shared_ptr<const PigmentNode> parse_density_entry(Parser& parser) {
  return read_contents(parser, default_density(), PatternUse::density);
}

// pattern{...} and pigment{...} as the body of a function.
std::shared_ptr<const PatternNode> parse_function_pattern(Parser& parser) {
  parser.expect_open("pattern");
  auto node = std::make_shared<PatternNode>();
  if (parser.accept(Keyword::object)) {
    node->kind = PatternKind::object;
    node->frequency = 0;
    parser.expect_open("object");
    node->object = parse_pattern_object(parser);
    parser.expect_close("object");
  } else if (!accept_pattern(parser, *node, PatternUse::function)) {
    parser.error_expected("a pattern");
  }
  while (accept_pattern_modifier(parser, *node)) {
  }
  parser.expect_close("pattern");
  return node;
}

// As in pigment_pattern, nothing comes from #default.
std::shared_ptr<const PigmentNode> parse_function_pigment(Parser& parser) {
  return parse_pigment(parser, std::make_shared<const PigmentNode>());
}

}  // namespace durer
