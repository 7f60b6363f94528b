// Reads the pattern statements of tests/data/pattern_samples.json into PatternNodes. It knows just
// the words that the table uses; the language itself is the parser's.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "tracer/functions/tape.h"
#include "tracer/scene/function.h"
#include "tracer/scene/pattern.h"

namespace durer {

// Something that this reader does not know.
struct UnknownWord : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class PatternReader {
 public:
  explicit PatternReader(const std::string& text) {
    for (size_t i = 0; i < text.size();) {
      if (std::isspace(static_cast<unsigned char>(text[i]))) {
        ++i;
      } else if (std::isalpha(static_cast<unsigned char>(text[i]))) {
        size_t end = i;
        while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) ||
                                     text[end] == '_'))
          ++end;
        words_.push_back(text.substr(i, end - i));
        i = end;
      } else if (std::isdigit(static_cast<unsigned char>(text[i])) || text[i] == '.') {
        char* end = nullptr;
        std::strtod(text.c_str() + i, &end);
        const size_t length =
            std::max<size_t>(1, static_cast<size_t>(end - text.c_str()) - i);
        words_.push_back(text.substr(i, length));
        i += length;
      } else {
        words_.emplace_back(1, text[i++]);
      }
    }
    read();
  }

  PatternNode node;
  std::vector<double> list;  // grey values of a colour list
  // Of normals: `bumps 0.5`, bump_size, accuracy, no_bump_scale.
  double amount = 0.5, accuracy = 0.02;
  bool no_bump_scale = false;

 private:
  bool at(const char* word) const { return next_ < words_.size() && words_[next_] == word; }
  bool accept(const char* word) {
    if (!at(word)) return false;
    ++next_;
    return true;
  }
  bool at_number() const {
    if (next_ >= words_.size()) return false;
    const char c = words_[next_][0];
    return std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '<';
  }
  double number() {
    const double sign = accept("-") ? -1 : 1;
    return sign * std::strtod(words_.at(next_++).c_str(), nullptr);
  }
  // <a,b,c>, x, y, z, a*x, or a number for all three.
  Vec3 vector() {
    if (accept("<")) {
      Vec3 v(0);
      for (int i = 0; i < 3 && !at(">"); ++i) {
        v[i] = number();
        accept(",");
      }
      if (!accept(">")) throw UnknownWord("long vector");
      return v;
    }
    double factor = accept("-") ? -1 : 1;
    if (!at("x") && !at("y") && !at("z")) {
      factor *= number();
      if (!accept("*")) return Vec3(factor);
    }
    if (accept("x")) return {factor, 0, 0};
    if (accept("y")) return {0, factor, 0};
    if (accept("z")) return {0, 0, factor};
    throw UnknownWord("vector");
  }
  void read();
  bool read_kind();
  void read_modifier();
  void read_warp();
  void read_function();
  void read_turbulence(Turbulence& turbulence);
  void read_color_list();
  void read_slope();

  std::vector<std::string> words_;
  size_t next_ = 0;
};

inline void PatternReader::read() {
  if (!read_kind()) throw UnknownWord(words_.at(next_));
  while (next_ < words_.size()) read_modifier();
}

inline bool PatternReader::read_kind() {
  struct Word {
    const char* word;
    PatternKind kind;
    bool unfolded;  // frequency 0
  };
  using K = PatternKind;
  static const Word kWords[] = {
      {"agate", K::agate, false}, {"boxed", K::boxed, false}, {"bozo", K::bozo, false},
      {"brick", K::brick, true}, {"bumps", K::bumps, false}, {"cells", K::cells, false},
      {"checker", K::checker, true}, {"crackle", K::crackle, false}, {"cubic", K::cubic, true},
      {"cylindrical", K::cylindrical, false}, {"dents", K::dents, false},
      {"facets", K::facets, false},
      {"granite", K::granite, false}, {"hexagon", K::hexagon, true},
      {"leopard", K::leopard, false}, {"onion", K::onion, false}, {"planar", K::planar, false},
      {"quilted", K::quilted, true}, {"radial", K::radial, false}, {"ripples", K::ripples, false},
      {"spherical", K::spherical, false}, {"spotted", K::spotted, false},
      {"square", K::square, true}, {"triangular", K::triangular, true}, {"waves", K::waves, false},
      {"wrinkles", K::wrinkles, false}, {"pavement", K::pavement, false}};
  for (const Word& word : kWords) {
    if (!accept(word.word)) continue;
    node.kind = word.kind;
    if (word.unfolded) node.frequency = 0;
    return true;
  }
  if (at("marble") || at("wood")) {
    node.kind = at("wood") ? K::wood : K::marble;
    node.wave = WaveKind::triangle;
    ++next_;
    return true;
  }
  if (at("spiral1") || at("spiral2")) {
    node.kind = at("spiral1") ? K::spiral1 : K::spiral2;
    ++next_;
    node.wave = WaveKind::triangle;
    node.arms = static_cast<int>(number());
    return true;
  }
  if (accept("gradient")) {
    node.kind = K::gradient;
    node.gradient = vector();
    return true;
  }
  if (accept("density_file")) {
    node.kind = K::density_file;
    accept("df3");
    accept("\"");
    while (!accept("\"")) node.density_file += words_.at(next_++);
    node.density_file = std::string(DURER_SOURCE_DIR) + "/tests/data/" + node.density_file;
    return true;
  }
  if (accept("aoi")) {
    node.kind = K::aoi;
    return true;
  }
  if (accept("slope")) {
    node.kind = K::slope;
    read_slope();
    return true;
  }
  if (accept("tiling")) {
    node.kind = K::tiling;
    node.tiling_type = static_cast<int>(number());
    return true;
  }
  if (accept("function")) {
    node.kind = K::function;
    read_function();
    return true;
  }
  int magnet = 0;
  if (accept("magnet")) magnet = static_cast<int>(number());
  if (at("mandel") || at("julia")) {
    const bool julia = accept("julia");
    if (!julia) ++next_;
    node.kind = magnet ? (julia ? K::magnet_julia : K::magnet_mandel)
                       : (julia ? K::julia : K::mandel);
    if (julia) {
      accept("<");
      node.fractal.coordinates.x = number();
      accept(",");
      node.fractal.coordinates.y = number();
      accept(">");
      accept(",");
    }
    if (magnet) node.fractal.magnet_type = magnet;
    node.fractal.iterations = static_cast<int>(number());
    return true;
  }
  return false;
}

inline void PatternReader::read_slope() {
  SlopeParameters& slope = node.slope;
  if (!accept("{")) {
    slope.direction = vector();
    return;
  }
  slope.is_point = accept("point_at");
  slope.direction = vector();
  if (accept(",")) {
    slope.low_slope = number();
    accept(",");
    slope.high_slope = number();
  }
  if (accept("altitude")) {
    slope.has_altitude = true;
    slope.altitude = vector();
    if (accept(",")) {
      slope.low_altitude = number();
      accept(",");
      slope.high_altitude = number();
    }
  }
  if (!accept("}")) throw UnknownWord("in slope");
}

inline void PatternReader::read_function() {
  // Sums of products of a number and x, y, z.
  accept("{");
  TapeBuilder builder(3);
  const auto factor = [&] {
    for (int axis = 0; axis < 3; ++axis)
      if (accept(axis == 0 ? "x" : axis == 1 ? "y" : "z")) return builder.parameter(axis);
    return builder.constant(number());
  };
  const auto product = [&] {
    auto term = factor();
    for (;;) {
      if (accept("*")) term = builder.binary(BinaryOperator::multiply, term, factor());
      else if (accept("/")) term = builder.binary(BinaryOperator::divide, term, factor());
      else return term;
    }
  };
  auto sum = product();
  while (accept("+")) sum = builder.binary(BinaryOperator::add, sum, product());
  if (!accept("}")) throw UnknownWord("function body");
  auto function = std::make_shared<FunctionNode>();
  function->compiled = builder.finish(sum);
  node.function = function;
}

inline void PatternReader::read_turbulence(Turbulence& turbulence) {
  for (;;) {
    if (accept("octaves")) turbulence.octaves = static_cast<int>(number());
    else if (accept("omega")) turbulence.omega = static_cast<float>(number());
    else if (accept("lambda")) turbulence.lambda = static_cast<float>(number());
    else return;
  }
}

inline void PatternReader::read_color_list() {
  while (accept("rgb")) {
    list.push_back(static_cast<float>(number()));
    accept(",");
  }
}

inline void PatternReader::read_modifier() {
  const std::string word = words_.at(next_++);
  const auto inside_fractal_or = [&](int& fractal, double& factor, int& pavement) {
    if (node.kind == PatternKind::pavement) {
      pavement = static_cast<int>(number());
    } else {
      fractal = static_cast<int>(number());
      accept(",");
      if (at_number()) factor = number();
    }
  };
  if (word == "color_map") {
    // Always black to white: the value itself.
    while (!accept("}")) ++next_;
  } else if (word == "rgb") {
    --next_;
    read_color_list();
  } else if (std::isdigit(static_cast<unsigned char>(word[0])) || word == "-") {
    --next_;
    amount = number();
  } else if (word == "bump_size") amount = number();
  else if (word == "accuracy") accuracy = number();
  else if (word == "no_bump_scale") no_bump_scale = true;
  else if (word == "size") node.facets.size = number();
  else if (word == "coords") node.facets.coordinates_size = number();
  else if (word == "frequency") node.frequency = static_cast<float>(number());
  else if (word == "phase") node.phase = static_cast<float>(number());
  else if (word == "ramp_wave") node.wave = WaveKind::ramp;
  else if (word == "triangle_wave") node.wave = WaveKind::triangle;
  else if (word == "sine_wave") node.wave = WaveKind::sine;
  else if (word == "scallop_wave") node.wave = WaveKind::scallop;
  else if (word == "cubic_wave") node.wave = WaveKind::cubic;
  else if (word == "poly_wave") {
    node.wave = WaveKind::poly;
    node.wave_exponent = at_number() ? static_cast<float>(number()) : 1;
  } else if (word == "noise_generator") node.noise_generator = static_cast<int>(number());
  else if (word == "turbulence") {
    node.has_turbulence = true;
    node.turbulence.strength = vector();
    read_turbulence(node.turbulence);
  } else if (word == "octaves" || word == "omega" || word == "lambda") {
    --next_;
    node.has_turbulence = true;
    read_turbulence(node.turbulence);
  } else if (word == "interpolate") {
    node.density_interpolation = static_cast<int>(number());
  } else if (word == "agate_turb") node.agate_turbulence = static_cast<float>(number());
  else if (word == "control0") node.quilt_control0 = static_cast<float>(number());
  else if (word == "control1") node.quilt_control1 = static_cast<float>(number());
  else if (word == "brick_size") node.brick.size = vector();
  else if (word == "mortar") node.brick.mortar = number();
  else if (word == "metric") node.crackle.metric = node.facets.metric = vector().x;
  else if (word == "offset") node.crackle.offset = number();
  else if (word == "solid") node.crackle.solid = true;
  else if (word == "form") {
    if (node.kind == PatternKind::pavement) node.pavement.form = static_cast<int>(number());
    else node.crackle.form = vector();
  } else if (word == "exponent") node.fractal.exponent = static_cast<int>(number());
  else if (word == "exterior")
    inside_fractal_or(node.fractal.exterior_type, node.fractal.exterior_factor,
                      node.pavement.exterior);
  else if (word == "interior")
    inside_fractal_or(node.fractal.interior_type, node.fractal.interior_factor,
                      node.pavement.interior);
  else if (word == "number_of_sides") node.pavement.sides = static_cast<int>(number());
  else if (word == "number_of_tiles") node.pavement.tiles = static_cast<int>(number());
  else if (word == "pattern") node.pavement.pattern = static_cast<int>(number());
  else if (word == "scale") append_transform(node.warps, Transform::scaling(vector()));
  else if (word == "translate") append_transform(node.warps, Transform::translation(vector()));
  else if (word == "rotate") append_transform(node.warps, Transform::rotation(vector()));
  else if (word == "matrix") {
    Matrix matrix;
    accept("<");
    for (Vec3& row : matrix.row)
      for (int i = 0; i < 3; ++i) {
        row[i] = number();
        accept(",");
      }
    accept(">");
    Transform transform;
    Transform::from_matrix(matrix, transform);
    append_transform(node.warps, transform);
  } else if (word == "warp") read_warp();
  else throw UnknownWord(word);
}

inline void PatternReader::read_warp() {
  accept("{");
  const std::string word = words_.at(next_++);
  const auto oriented = [&](auto warp) {
    while (!at("}")) {
      if (accept("orientation")) warp.orientation = normalize_or_zero(vector());
      else if (accept("dist_exp")) warp.distance_exponent = number();
      else break;
    }
    return warp;
  };
  if (word == "turbulence") {
    Turbulence turbulence;
    turbulence.strength = vector();
    read_turbulence(turbulence);
    node.warps.emplace_back(turbulence);
  } else if (word == "repeat") {
    RepeatWarp repeat;
    const Vec3 along = vector();
    for (int i = 0; i < 3; ++i)
      if (along[i] != 0) repeat.axis = i, repeat.width = static_cast<float>(along[i]);
    for (;;) {
      if (accept("flip")) repeat.flip = vector();
      else if (accept("offset")) repeat.offset = vector();
      else break;
    }
    node.warps.emplace_back(repeat);
  } else if (word == "black_hole") {
    BlackHoleWarp hole;
    hole.center = vector();
    accept(",");
    hole.radius = number();
    // The correction of spec/textures.md 5, each time one of the two is read.
    const auto correct = [&] {
      for (int i = 0; hole.has_repeat && i < 3; ++i) {
        if (hole.repeat[i] <= 0) continue;
        hole.center[i] = std::max(hole.center[i], hole.radius);
        hole.repeat[i] =
            std::max(hole.repeat[i], hole.center[i] + hole.radius + hole.uncertainty[i]);
      }
    };
    for (;;) {
      if (accept("strength")) hole.strength = number();
      else if (accept("falloff")) hole.power = number();
      else if (accept("inverse")) hole.inverted = true;
      else if (accept("repeat")) hole.repeat = vector(), hole.has_repeat = true, correct();
      else if (accept("turbulence"))
        hole.uncertainty = vector(), hole.has_uncertainty = true, correct();
      else break;
    }
    node.warps.emplace_back(hole);
  } else if (word == "planar") {
    PlanarWarp planar;
    if (!at("}")) {
      planar.orientation = normalize_or_zero(vector());
      accept(",");
      planar.distance = number();
    }
    node.warps.emplace_back(planar);
  } else if (word == "cylindrical") node.warps.emplace_back(oriented(CylindricalWarp{}));
  else if (word == "spherical") node.warps.emplace_back(oriented(SphericalWarp{}));
  else if (word == "toroidal") {
    ToroidalWarp toroidal = oriented(ToroidalWarp{});
    if (accept("major_radius")) toroidal.major_radius = number();
    node.warps.emplace_back(oriented(toroidal));
  } else if (word == "cubic") node.warps.emplace_back(CubicWarp{});
  if (!accept("}")) throw UnknownWord("in warp: " + words_.at(next_));
}

}  // namespace durer
