#include "parser/statements/warp.h"

#include <algorithm>
#include <cmath>

#include "parser/parser.h"
#include "parser/statements/transformations.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

RepeatWarp parse_repeat(Parser& parser) {
  RepeatWarp warp;
  const Vec3 v = parser.parse_vector();
  int axes = 0;
  for (int i = 0; i < 3; ++i) {
    if (v[i] == 0) continue;
    ++axes;
    warp.axis = i;
    warp.width = static_cast<float>(v[i]);
  }
  if (axes != 1) parser.error("repeat takes a vector along exactly one axis");
  for (;;) {
    if (parser.accept(Keyword::flip)) {
      warp.flip = parser.parse_vector();
    } else if (parser.accept(Keyword::offset)) {
      warp.offset = parser.parse_vector();
    } else {
      return warp;
    }
  }
}

// Holes must fit into their blocks (spec/textures.md 5).
void fit_black_hole(Parser& parser, BlackHoleWarp& warp) {
  for (int i = 0; i < 3; ++i) {
    if (!(warp.repeat[i] > 0)) continue;
    warp.center[i] = std::max(warp.center[i], warp.radius);
    const double needed = warp.center[i] + warp.radius + warp.uncertainty[i];
    if (warp.repeat[i] < needed) {
      parser.warning("the black hole does not fit into its block; the block is made larger");
      warp.repeat[i] = needed;
    }
  }
}

BlackHoleWarp parse_black_hole(Parser& parser) {
  BlackHoleWarp warp;
  warp.center = parser.parse_vector();
  parser.accept_comma();
  warp.radius = parser.parse_float();
  for (;;) {
    if (parser.accept(Keyword::strength)) {
      warp.strength = parser.parse_float();
    } else if (parser.accept(Keyword::falloff)) {
      warp.power = parser.parse_float();
    } else if (parser.accept(Keyword::inverse)) {
      warp.inverted = true;
    } else if (parser.accept(Keyword::type)) {
      warp.type = parser.parse_int();
    } else if (parser.accept(Keyword::repeat)) {
      warp.repeat = parser.parse_vector();
      warp.has_repeat = true;
      fit_black_hole(parser, warp);
    } else if (parser.accept(Keyword::turbulence)) {
      warp.uncertainty = parser.parse_vector();
      warp.has_uncertainty = true;
      if (warp.has_repeat) fit_black_hole(parser, warp);
    } else {
      return warp;
    }
  }
}

// Of the zero vector: not a number, as in POV-Ray.
Vec3 parse_orientation(Parser& parser) {
  const Vec3 orientation = parser.parse_vector();
  return orientation / length(orientation);
}

template <typename RoundWarp>
RoundWarp parse_round(Parser& parser, RoundWarp warp, double* major_radius) {
  for (;;) {
    if (parser.accept(Keyword::orientation)) {
      warp.orientation = parse_orientation(parser);
    } else if (parser.accept(Keyword::dist_exp)) {
      warp.distance_exponent = parser.parse_float();
    } else if (major_radius && parser.accept(Keyword::major_radius)) {
      *major_radius = parser.parse_float();
    } else {
      return warp;
    }
  }
}

Warp parse_warp(Parser& parser) {
  if (parser.accept(Keyword::repeat)) return parse_repeat(parser);
  if (parser.accept(Keyword::black_hole)) return parse_black_hole(parser);
  if (parser.accept(Keyword::turbulence)) {
    Turbulence turbulence;
    turbulence.strength = parser.parse_vector();
    while (accept_turbulence_item(parser, turbulence)) {
    }
    return turbulence;
  }
  if (parser.accept(Keyword::planar)) {
    PlanarWarp warp;
    if (parser.at_expression()) {
      warp.orientation = parse_orientation(parser);
      parser.accept_comma();
      warp.distance = parser.parse_float();
    }
    return warp;
  }
  if (parser.accept(Keyword::cylindrical)) {
    return parse_round(parser, CylindricalWarp{}, nullptr);
  }
  if (parser.accept(Keyword::spherical)) return parse_round(parser, SphericalWarp{}, nullptr);
  if (parser.accept(Keyword::toroidal)) {
    double major_radius = 1;
    ToroidalWarp warp = parse_round(parser, ToroidalWarp{}, &major_radius);
    warp.major_radius = major_radius;
    return warp;
  }
  if (parser.accept(Keyword::cubic)) return CubicWarp{};
  parser.error_expected(
      "turbulence, repeat, black_hole, planar, cylindrical, spherical, toroidal or cubic");
}

}  // namespace

bool accept_turbulence_item(Parser& parser, Turbulence& turbulence) {
  if (parser.accept(Keyword::turbulence)) {
    turbulence.strength = parser.parse_vector();
  } else if (parser.accept(Keyword::octaves)) {
    turbulence.octaves = std::clamp(parser.parse_int(), 1, 10);
  } else if (parser.accept(Keyword::omega)) {
    turbulence.omega = static_cast<float>(parser.parse_float());
  } else if (parser.accept(Keyword::lambda)) {
    turbulence.lambda = static_cast<float>(parser.parse_float());
  } else {
    return false;
  }
  return true;
}

bool accept_warp(Parser& parser, PatternNode& node) {
  Transform transform;
  if (accept_transformation(parser, transform)) {
    append_transform(node.warps, transform);
  } else if (accept_turbulence_item(parser, node.turbulence)) {
    node.has_turbulence = true;
  } else if (parser.accept(Keyword::warp)) {
    parser.expect_open("warp");
    node.warps.push_back(parse_warp(parser));
    parser.expect_close("warp");
  } else {
    return false;
  }
  return true;
}

}  // namespace durer
