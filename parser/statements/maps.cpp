// color_map, pigment_map, normal_map, slope_map, texture_map, density_map (spec/textures.md 10).
#include "parser/parser.h"
#include "parser/statements/map_entries.h"
#include "parser/statements/pattern.h"
#include "parser/statements/textures.h"
#include "tracer/texture/default_maps.h"

namespace durer {
namespace {

constexpr size_t kMostEntries = 256;

// `word { ID }` or `word { [v item] ... }`.
template <typename Map, typename ReadEntry>
std::shared_ptr<const Map> parse_map(Parser& parser, const char* what, ValueKind kind,
                                     ReadEntry read_entry) {
  parser.expect_open(what);
  if (auto named = parser.accept_identifier<Map>(kind)) {
    parser.expect_close(what);
    return named;
  }
  auto map = std::make_shared<Map>();
  while (parser.accept(Symbol::bracket_open)) {
    read_entry(*map);
    parser.expect(Symbol::bracket_close);
    if (map->entries.size() > kMostEntries) {
      parser.error(std::string("a ") + what + " has at most 256 entries");
    }
  }
  if (map->entries.empty()) {
    parser.error_expected(std::string("at least one entry of the ") + what);
  }
  parser.expect_close(what);
  return map;
}

float parse_position(Parser& parser, MapEntries entries = MapEntries::places) {
  if (entries == MapEntries::weights && !parser.at_color_or_expression()) return 1;
  const float position = static_cast<float>(parser.parse_float());
  parser.accept_comma();
  return position;
}

void add_color(ColorMap& map, float position, const ColorRGBFT& color) {
  // A repeated entry changes nothing.
  if (!map.entries.empty() && map.entries.back().position == position &&
      map.entries.back().item == color) {
    return;
  }
  map.entries.push_back({position, color});
}

void parse_color_entry(Parser& parser, ColorMap& map) {
  const float first = parse_position(parser);
  if (parser.at_color_start()) {
    add_color(map, first, parser.parse_color());
    return;
  }
  if (parser.at(Symbol::less)) parser.error_expected("a colour");
  const Value value = parser.parse_numeric();
  if (value.terms() == 5) {
    add_color(map, first, value.color());
  } else if (value.terms() == 1) {
    // The old form with two places and two colours.
    parser.accept_comma();
    add_color(map, first, parser.parse_color());
    // This word and, if there is one more, the colour's own.
    if (!parser.accept(Keyword::color)) parser.error_expected("'color'");
    add_color(map, static_cast<float>(value.number()), parser.parse_color());
  } else {
    parser.error("a colour_map entry takes a colour here");
  }
}

}  // namespace

std::shared_ptr<const ColorMap> parse_color_map(Parser& parser) {
  return parse_map<ColorMap>(parser, "color_map", ValueKind::color_map,
                             [&](ColorMap& map) { parse_color_entry(parser, map); });
}

std::shared_ptr<const ColorMap> parse_color_list(Parser& parser, const PatternNode& pattern) {
  auto map = std::make_shared<ColorMap>(default_color_map(pattern));
  const int count = list_length(pattern.kind);
  for (int i = 0; i < count && parser.at_color_or_expression(); ++i) {
    map->entries[i].item = parser.parse_color();
    parser.accept_comma();
  }
  return map;
}

std::shared_ptr<const PigmentMap> parse_pigment_map(Parser& parser, MapEntries entries) {
  return parse_map<PigmentMap>(parser, "pigment_map", ValueKind::pigment_map,
                               [&](PigmentMap& map) {
                                 const float position = parse_position(parser, entries);
                                 map.entries.push_back({position, parse_pigment_entry(parser)});
                               });
}

std::shared_ptr<const PigmentMap> parse_density_map(Parser& parser, MapEntries entries) {
  return parse_map<PigmentMap>(parser, "density_map", ValueKind::density_map,
                               [&](PigmentMap& map) {
                                 const float position = parse_position(parser, entries);
                                 map.entries.push_back({position, parse_density_entry(parser)});
                               });
}

std::shared_ptr<const NormalMap> parse_normal_map(Parser& parser, MapEntries entries) {
  return parse_map<NormalMap>(parser, "normal_map", ValueKind::normal_map, [&](NormalMap& map) {
    const float position = parse_position(parser, entries);
    map.entries.push_back({position, parse_normal_entry(parser)});
  });
}

std::shared_ptr<const TextureMap> parse_texture_map(Parser& parser, MapEntries entries) {
  return parse_map<TextureMap>(parser, "texture_map", ValueKind::texture_map,
                               [&](TextureMap& map) {
                                 const float position = parse_position(parser, entries);
                                 map.entries.push_back({position, parse_texture_entry(parser)});
                               });
}

std::shared_ptr<const SlopeMap> parse_slope_map(Parser& parser) {
  return parse_map<SlopeMap>(parser, "slope_map", ValueKind::slope_map, [&](SlopeMap& map) {
    const float position = parse_position(parser);
    const Vec2 v = parser.parse_uv();
    map.entries.push_back({position, {static_cast<float>(v.x), static_cast<float>(v.y)}});
  });
}

}  // namespace durer
