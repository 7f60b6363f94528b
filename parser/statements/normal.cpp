// normal{} (spec/textures.md 14).
#include "parser/parser.h"
#include "parser/statements/map_entries.h"
#include "parser/statements/objects.h"
#include "parser/statements/pattern.h"
#include "parser/statements/textures.h"

namespace durer {
namespace {

class NormalReader {
 public:
  NormalReader(Parser& parser, NormalNode& node) : parser_(parser), node_(node) {}

  void read() {
    if (parser_.accept(Keyword::uv_mapping)) {
      while (parser_.accept(Keyword::uv_mapping)) {
        // Once more changes nothing.
      }
      read_uv();
      return;
    }
    read_start();
    while (accept_item() || accept_pattern_modifier(parser_, node_.pattern.edit())) {
    }
    check_pattern(parser_, *node_.pattern);
    if (node_.pattern->kind == PatternKind::average && !node_.normal_map) {
      parser_.error("average needs a normal_map");
    }
  }

 private:
  // What follows belongs to a new normal at (u, v, 0), the only entry of a map, up to an amount behind its
  // modifiers: that one and all modifiers after it belong to the normal around it. Of these only
  // no_bump_scale has an effect (measured on povray 3.7).
  void read_uv() {
    auto inner = std::make_shared<NormalNode>();
    NormalReader(parser_, *inner).read();
    const bool copied_no_bump_scale = node_.no_bump_scale;
    node_ = NormalNode{};
    node_.pattern.edit().kind = PatternKind::uv_mapping;
    read_amount();
    while (accept_item() || accept_pattern_modifier(parser_, node_.pattern.edit())) {
    }
    if (node_.normal_map || node_.slope_map) {
      parser_.error("a map belongs before the amount of a uv_mapping normal");
    }
    const bool no_bump_scale = node_.no_bump_scale || copied_no_bump_scale;
    node_ = NormalNode{};
    node_.pattern.edit().kind = PatternKind::uv_mapping;
    node_.no_bump_scale = no_bump_scale;
    auto map = std::make_shared<NormalMap>();
    map->entries.push_back({0, std::move(inner)});
    node_.normal_map = std::move(map);
  }

  void read_amount() {
    parser_.accept_comma();
    if (parser_.at_expression()) node_.bump_size = static_cast<float>(parser_.parse_float());
  }

  void read_start() {
    if (parser_.accept(Keyword::bump_map)) {
      parse_bump_map(parser_, node_);
    } else if (parser_.accept(Keyword::object)) {
      node_.pattern.edit().kind = PatternKind::object;
      node_.pattern.edit().frequency = 0;
      parser_.expect_open("object");
      node_.pattern.edit().object = parse_pattern_object(parser_);
      read_list(2);
      parser_.expect_close("object");
      read_amount();
    } else if (accept_pattern(parser_, node_.pattern.edit(), PatternUse::normal)) {
      if (const int count = list_length(node_.pattern->kind)) {
        read_list(count);
        read_amount();
      } else {
        read_amount();
      }
    } else if (node_.pattern->kind != PatternKind::none) {
      read_amount();  // behind an identifier
    }
  }

  // A list also takes the place of a slope map, and of an accuracy (measured on povray 3.7).
  void read_list(int count) {
    node_.normal_map = nullptr;
    node_.slope_map = nullptr;
    node_.accuracy = NormalNode{}.accuracy;
    if (!parser_.at(Keyword::normal)) return;
    auto map = std::make_shared<NormalMap>();
    while (static_cast<int>(map->entries.size()) < count && parser_.accept(Keyword::normal)) {
      const float place = static_cast<float>(map->entries.size());
      map->entries.push_back({place, parse_normal(parser_, default_texture(parser_)->normal)});
      parser_.accept_comma();
    }
    while (static_cast<int>(map->entries.size()) < count) {
      const float place = static_cast<float>(map->entries.size());
      map->entries.push_back({place, default_or_flat()});
    }
    node_.normal_map = std::move(map);
  }

  std::shared_ptr<const NormalNode> default_or_flat() {
    if (const auto& normal = default_texture(parser_)->normal) return normal;
    auto flat = std::make_shared<NormalNode>();
    flat->pattern.edit().kind = PatternKind::bumps;
    flat->bump_size = 0;
    return flat;
  }

  bool accept_item() {
    if (parser_.accept(Keyword::bump_size)) {
      node_.bump_size = static_cast<float>(parser_.parse_float());
    } else if (parser_.accept(Keyword::accuracy)) {
      node_.accuracy = static_cast<float>(parser_.parse_float());
    } else if (parser_.accept(Keyword::no_bump_scale)) {
      node_.no_bump_scale = true;
    } else if (parser_.accept(Keyword::normal_map)) {
      if (list_length(node_.pattern->kind) > 0 || node_.pattern->kind == PatternKind::facets ||
          node_.pattern->kind == PatternKind::bump_map) {
        parser_.error("this pattern takes no normal_map");
      }
      node_.normal_map = parse_normal_map(
          parser_, node_.pattern->kind == PatternKind::average ? MapEntries::weights : MapEntries::places);
      node_.slope_map = nullptr;  // the last map holds
    } else if (parser_.accept(Keyword::slope_map)) {
      if (list_length(node_.pattern->kind) > 0 || node_.pattern->kind == PatternKind::average ||
          node_.pattern->kind == PatternKind::bump_map ||
          node_.pattern->kind == PatternKind::uv_mapping) {
        parser_.error("this pattern takes no slope_map");
      }
      node_.slope_map = parse_slope_map(parser_);
      node_.normal_map = nullptr;
    } else {
      return false;
    }
    return true;
  }

  Parser& parser_;
  NormalNode& node_;
};

std::shared_ptr<const NormalNode> read_contents(Parser& parser,
                                                const std::shared_ptr<const NormalNode>& start) {
  const auto named = parser.accept_identifier<NormalNode>(ValueKind::normal);
  auto node = named   ? std::make_shared<NormalNode>(*named)
              : start ? std::make_shared<NormalNode>(*start)
                      : std::make_shared<NormalNode>();
  NormalReader(parser, *node).read();
  parser.check_nesting(std::shared_ptr<const NormalNode>(node));
  return node;
}

}  // namespace

std::shared_ptr<const NormalNode> parse_normal(Parser& parser,
                                               const std::shared_ptr<const NormalNode>& start) {
  auto node = parse_default_normal(parser, start);
  if (node->pattern->kind == PatternKind::none) parser.error("this normal has no pattern");
  return node;
}

void parse_bump_map(Parser& parser, NormalNode& normal) {
  PatternNode& pattern = normal.pattern.edit();
  pattern.kind = PatternKind::bump_map;
  pattern.frequency = 0;
  pattern.position = parser.position();
  parser.expect_open("bump_map");
  pattern.image = parse_image_options(parser, PatternKind::bump_map, &normal.bump_size);
  parser.expect_close("bump_map");
}

std::shared_ptr<const NormalNode> parse_default_normal(
    Parser& parser, const std::shared_ptr<const NormalNode>& start) {
  parser.expect_open("normal");
  auto node = read_contents(parser, start);
  parser.expect_close("normal");
  return node;
}

std::shared_ptr<const NormalNode> parse_normal_entry(Parser& parser) {
  return read_contents(parser, default_texture(parser)->normal);
}

}  // namespace durer
