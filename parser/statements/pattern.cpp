#include "parser/statements/pattern.h"

#include "parser/parser.h"
#include "parser/statements/objects.h"
#include "parser/statements/textures.h"
#include "parser/statements/warp.h"
#include "tracer/image/density_grid.h"

namespace durer {
namespace {

using K = PatternKind;

// Patterns that are a keyword and nothing else.
struct SimplePattern {
  Keyword keyword;
  PatternKind kind;
};
constexpr SimplePattern kSimple[] = {
    {Keyword::agate, K::agate},         {Keyword::aoi, K::aoi},
    {Keyword::average, K::average},     {Keyword::boxed, K::boxed},
    {Keyword::bozo, K::bozo},           {Keyword::brick, K::brick},
    {Keyword::bumps, K::bumps},         {Keyword::cells, K::cells},
    {Keyword::checker, K::checker},     {Keyword::crackle, K::crackle},
    {Keyword::cubic, K::cubic},         {Keyword::cylindrical, K::cylindrical},
    {Keyword::dents, K::dents},         {Keyword::granite, K::granite},
    {Keyword::hexagon, K::hexagon},     {Keyword::leopard, K::leopard},
    {Keyword::marble, K::marble},       {Keyword::onion, K::onion},
    {Keyword::planar, K::planar},       {Keyword::quilted, K::quilted},
    {Keyword::radial, K::radial},       {Keyword::ripples, K::ripples},
    {Keyword::spherical, K::spherical}, {Keyword::spotted, K::spotted},
    {Keyword::square, K::square},       {Keyword::triangular, K::triangular},
    {Keyword::waves, K::waves},         {Keyword::wood, K::wood},
    {Keyword::wrinkles, K::wrinkles},
};

double float_then_comma(Parser& parser) {
  const double value = parser.parse_float();
  parser.accept_comma();
  return value;
}

void parse_range(Parser& parser, double& low, double& high) {
  if (!parser.accept_comma() && !parser.at_expression()) return;
  low = parser.parse_float();
  parser.accept_comma();
  high = parser.parse_float();
  if (low == high) parser.warning("an empty range has no effect");
}

void parse_slope(Parser& parser, PatternNode& node) {
  parser.note_experimental("slope pattern");
  SlopeParameters& slope = node.slope;
  slope = {};
  if (!parser.accept(Symbol::brace_open)) {
    slope.direction = parser.parse_vector();
  } else {
    slope.is_point = parser.accept(Keyword::point_at);
    slope.direction = parser.parse_vector();
    parse_range(parser, slope.low_slope, slope.high_slope);
    if (parser.accept(Keyword::altitude)) {
      if (slope.is_point) parser.error("altitude and point_at do not go together");
      slope.has_altitude = true;
      slope.altitude = parser.parse_vector();
      parse_range(parser, slope.low_altitude, slope.high_altitude);
    }
    parser.expect_close("slope");
  }
  if (length(slope.direction) == 0 && length(slope.altitude) == 0 && !slope.is_point) {
    parser.error("slope needs a direction that is not the zero vector");
  }
}

void parse_fractal(Parser& parser, PatternNode& node, bool julia) {
  if (julia) {
    node.fractal.coordinates = parser.parse_uv();
    parser.accept_comma();
  }
  node.fractal.iterations = parser.parse_int();
  if (node.fractal.iterations < 0) parser.error("the iterations of a fractal cannot be negative");
}

void parse_magnet(Parser& parser, PatternNode& node) {
  node.fractal.magnet_type = parser.parse_int();
  if (node.fractal.magnet_type < 1 || node.fractal.magnet_type > 2) {
    parser.error("magnet is followed by 1 or 2");
  }
  if (parser.accept(Keyword::mandel)) {
    node.kind = K::magnet_mandel;
    parse_fractal(parser, node, false);
  } else if (parser.accept(Keyword::julia)) {
    node.kind = K::magnet_julia;
    parse_fractal(parser, node, true);
  } else {
    parser.error_expected("mandel or julia");
  }
}

void parse_density_file(Parser& parser, PatternNode& node) {
  if (!parser.accept(Keyword::df3)) parser.error_expected("df3");
  const std::string name = parser.parse_path_string();
  node.density_file = parser.find_file(name, FileType::density);
  if (node.density_file.empty()) parser.error("the density file '" + name + "' is not found");
  try {
    DensityGrid::check(node.density_file);
  } catch (const std::runtime_error& failure) {
    parser.error(failure.what());
  }
}

void parse_pavement_or_tiling(Parser& parser, PatternNode& node, bool tiling) {
  if (tiling) {
    node.tiling_type = parser.parse_int();
    if (node.tiling_type < 1 || node.tiling_type > 27) {
      parser.error("there are tilings 1 to 27");
    }
  } else {
    node.pavement = {};
  }
}

// These take the value as it is, unless frequency is given.
bool starts_without_frequency(PatternKind kind) {
  return list_length(kind) > 0 || kind == K::quilted || kind == K::image_pattern ||
         kind == K::image_map || kind == K::bump_map || kind == K::object;
}

bool starts_with_triangle_wave(PatternKind kind) {
  return kind == K::marble || kind == K::wood || kind == K::spiral1 || kind == K::spiral2;
}

// The keyword and its arguments; false: no pattern.
bool accept_kind(Parser& parser, PatternNode& node, PatternUse use) {
  if (parser.peek().kind != TokenKind::keyword) return false;
  const Keyword keyword = parser.peek().keyword;
  if (const PatternKind simple = simple_pattern(keyword); simple != K::none) {
    parser.next();
    node.kind = simple;
    if (simple == K::crackle) node.crackle = {};  // others keep what a copy brings along
    return true;
  }
  if (parser.accept(Keyword::gradient)) {
    node.kind = K::gradient;
    node.gradient = parser.parse_vector();
  } else if (parser.accept(Keyword::spiral1)) {
    node.kind = K::spiral1;
    node.arms = parser.parse_int();
  } else if (parser.accept(Keyword::spiral2)) {
    node.kind = K::spiral2;
    node.arms = parser.parse_int();
  } else if (parser.accept(Keyword::mandel)) {
    node.kind = K::mandel;
    parse_fractal(parser, node, false);
  } else if (parser.accept(Keyword::julia)) {
    node.kind = K::julia;
    parse_fractal(parser, node, true);
  } else if (parser.accept(Keyword::magnet)) {
    parse_magnet(parser, node);
  } else if (parser.accept(Keyword::slope)) {
    node.kind = K::slope;
    parse_slope(parser, node);
  } else if (parser.accept(Keyword::density_file)) {
    node.kind = K::density_file;
    parse_density_file(parser, node);
  } else if (parser.accept(Keyword::image_pattern)) {
    node.kind = K::image_pattern;
    parser.expect_open("image_pattern");
    node.image = parse_image_options(parser, K::image_pattern);
    parser.expect_close("image_pattern");
  } else if (use == PatternUse::pigment && parser.accept(Keyword::image_map)) {
    node.kind = K::image_map;
    parser.expect_open("image_map");
    node.image = parse_image_options(parser, K::image_map);
    parser.expect_close("image_map");
  } else if (use == PatternUse::normal && parser.at(Keyword::bump_map)) {
    return false;  // has a bump_size of its own: the normal's statement reads it
  } else if (parser.accept(Keyword::pavement)) {
    node.kind = K::pavement;
    parse_pavement_or_tiling(parser, node, false);
  } else if (parser.accept(Keyword::tiling)) {
    node.kind = K::tiling;
    parse_pavement_or_tiling(parser, node, true);
  } else if (use == PatternUse::normal && parser.accept(Keyword::facets)) {
    node.kind = K::facets;
    node.facets = {};
  } else if (parser.accept(Keyword::pigment_pattern)) {
    node.kind = K::pigment_pattern;
    node.pigment = parse_pigment(parser, std::make_shared<const PigmentNode>());
  } else if (parser.accept(Keyword::function)) {
    node.kind = K::function;
    node.function = parser.parse_function(FunctionParameters::xyz);
  } else {
    return false;
  }
  return true;
}

// POV-Ray 3.7 knows these, but not as pattern functions (spec/textures.md 4).
bool at_pattern_without_function(Parser& parser) {
  for (const Keyword keyword :
       {Keyword::square, Keyword::triangular, Keyword::pavement, Keyword::tiling, Keyword::slope,
        Keyword::aoi, Keyword::average}) {
    if (parser.at(keyword)) return true;
  }
  return false;
}

// The most tiles, and of so many tiles the most patterns (spec/textures.md 9).
void check_pavement(Parser& parser, const PavementParameters& pavement) {
  const int row = pavement.sides == 3 ? 0 : pavement.sides == 4 ? 1 : 2;
  static constexpr int kPatterns[3][6] = {
      {1, 1, 1, 3, 4, 12}, {1, 1, 2, 5, 12, 35}, {1, 1, 3, 7, 22, 0}};
  if (pavement.sides != 3 && pavement.sides != 4 && pavement.sides != 6) {
    parser.error("the tiles of a pavement have 3, 4 or 6 sides");
  }
  if (pavement.tiles < 1 || pavement.tiles > (pavement.sides == 6 ? 5 : 6)) {
    parser.error("a pavement of this form is made of 1 to " +
                 std::to_string(pavement.sides == 6 ? 5 : 6) + " tiles");
  }
  const int most = kPatterns[row][pavement.tiles - 1];
  if (pavement.pattern < 1 || pavement.pattern > most) {
    parser.error("a pavement of this form and number of tiles has patterns 1 to " +
                 std::to_string(most));
  }
}

}  // namespace

PatternKind simple_pattern(Keyword keyword) {
  for (const SimplePattern& simple : kSimple) {
    if (simple.keyword == keyword) return simple.kind;
  }
  return K::none;
}

int list_length(PatternKind kind) {
  switch (kind) {
    case K::checker:
    case K::brick:
    case K::object:
      return 2;
    case K::hexagon:
      return 3;
    case K::square:
      return 4;
    case K::triangular:
    case K::cubic:
      return 6;
    default:
      return 0;
  }
}

bool accept_pattern(Parser& parser, PatternNode& node, PatternUse use) {
  node.position = parser.position();
  if (use == PatternUse::function && at_pattern_without_function(parser)) return false;
  if (!accept_kind(parser, node, use)) return false;
  if (starts_without_frequency(node.kind)) node.frequency = 0;
  if (starts_with_triangle_wave(node.kind)) node.wave = WaveKind::triangle;
  return true;
}

void check_pattern(Parser& parser, const PatternNode& node) {
  if (node.kind == K::pavement) check_pavement(parser, node.pavement);
}

bool accept_pattern_modifier(Parser& parser, PatternNode& node) {
  if (parser.peek().kind != TokenKind::keyword) return false;
  if (accept_warp(parser, node)) return true;
  struct Wave {
    Keyword keyword;
    WaveKind kind;
  };
  static constexpr Wave kWaves[] = {
      {Keyword::ramp_wave, WaveKind::ramp},       {Keyword::sine_wave, WaveKind::sine},
      {Keyword::triangle_wave, WaveKind::triangle}, {Keyword::scallop_wave, WaveKind::scallop},
      {Keyword::cubic_wave, WaveKind::cubic},
  };
  for (const Wave& wave : kWaves) {
    if (!parser.accept(wave.keyword)) continue;
    node.wave = wave.kind;
    return true;
  }
  auto belongs_to = [&](bool yes, const char* pattern) {
    if (!yes) parser.error(std::string("this item belongs to the pattern ") + pattern);
  };
  const bool crackle = node.kind == K::crackle, facets = node.kind == K::facets;
  const bool fractal = node.kind == K::mandel || node.kind == K::julia ||
                       node.kind == K::magnet_mandel || node.kind == K::magnet_julia;
  const bool pavement = node.kind == K::pavement;
  if (parser.accept(Keyword::poly_wave)) {
    node.wave = WaveKind::poly;
    node.wave_exponent = static_cast<float>(parser.parse_optional_float(1));
  } else if (parser.accept(Keyword::frequency)) {
    node.frequency = static_cast<float>(parser.parse_float());
  } else if (parser.accept(Keyword::phase)) {
    node.phase = static_cast<float>(parser.parse_float());
  } else if (parser.accept(Keyword::noise_generator)) {
    const int generator = parser.parse_int();
    if (generator < 0 || generator > 3) parser.error("noise_generator is 0, 1, 2 or 3");
    node.noise_generator |= generator;
  } else if (parser.accept(Keyword::agate_turb)) {
    belongs_to(node.kind == K::agate, "agate");
    node.agate_turbulence = static_cast<float>(parser.parse_float());
  } else if (parser.accept(Keyword::control0)) {
    belongs_to(node.kind == K::quilted, "quilted");
    node.quilt_control0 = static_cast<float>(parser.parse_float());
  } else if (parser.accept(Keyword::control1)) {
    belongs_to(node.kind == K::quilted, "quilted");
    node.quilt_control1 = static_cast<float>(parser.parse_float());
  } else if (parser.accept(Keyword::brick_size)) {
    belongs_to(node.kind == K::brick, "brick");
    node.brick.size = parser.parse_vector();
  } else if (parser.accept(Keyword::mortar)) {
    belongs_to(node.kind == K::brick, "brick");
    node.brick.mortar = parser.parse_float();
  } else if (parser.accept(Keyword::form)) {
    belongs_to(crackle || pavement, "crackle or pavement");
    if (crackle) {
      node.crackle.form = parser.parse_vector();
    } else {
      node.pavement.form = parser.parse_int();
    }
  } else if (parser.accept(Keyword::metric)) {
    belongs_to(crackle || facets, "crackle or facets");
    const double metric = parser.parse_vector().x;
    (crackle ? node.crackle.metric : node.facets.metric) = metric;
  } else if (parser.accept(Keyword::offset)) {
    belongs_to(crackle, "crackle");
    node.crackle.offset = parser.parse_float();
  } else if (parser.accept(Keyword::solid)) {
    belongs_to(crackle, "crackle");
    node.crackle.solid = true;
  } else if (parser.accept(Keyword::coords)) {
    belongs_to(facets, "facets");
    node.facets.coordinates_size = parser.parse_float();
  } else if (parser.accept(Keyword::size)) {
    belongs_to(facets, "facets");
    node.facets.size = parser.parse_float();
  } else if (parser.accept(Keyword::exponent)) {
    belongs_to(node.kind == K::mandel || node.kind == K::julia, "mandel or julia");
    node.fractal.exponent = parser.parse_int();
    if (node.fractal.exponent < 2 || node.fractal.exponent > 33) {
      parser.warning("the exponent of a fractal lies between 2 and 33; 2 is used");
      node.fractal.exponent = 2;
    }
  } else if (parser.accept(Keyword::exterior)) {
    belongs_to(fractal || pavement, "mandel, julia, magnet or pavement");
    if (pavement) {
      node.pavement.exterior = parser.parse_int();
    } else {
      node.fractal.exterior_type = static_cast<int>(float_then_comma(parser));
      node.fractal.exterior_factor = parser.parse_float();
      if (node.fractal.exterior_type < 0 || node.fractal.exterior_type > 8) {
        parser.error("there are exterior types 0 to 8");
      }
    }
  } else if (parser.accept(Keyword::interior)) {
    belongs_to(fractal || pavement, "mandel, julia, magnet or pavement");
    if (pavement) {
      node.pavement.interior = parser.parse_int();
    } else {
      node.fractal.interior_type = static_cast<int>(float_then_comma(parser));
      node.fractal.interior_factor = parser.parse_float();
      if (node.fractal.interior_type < 0 || node.fractal.interior_type > 6) {
        parser.error("there are interior types 0 to 6");
      }
    }
  } else if (parser.accept(Keyword::number_of_sides)) {
    belongs_to(pavement, "pavement");
    node.pavement.sides = parser.parse_int();
  } else if (parser.accept(Keyword::number_of_tiles)) {
    belongs_to(pavement, "pavement");
    node.pavement.tiles = parser.parse_int();
  } else if (parser.accept(Keyword::pattern)) {
    belongs_to(pavement, "pavement");
    node.pavement.pattern = parser.parse_int();
  } else if (parser.accept(Keyword::interpolate)) {
    belongs_to(node.kind == K::density_file, "density_file");
    node.density_interpolation = parser.parse_int();
  } else {
    return false;
  }
  return true;
}

}  // namespace durer
