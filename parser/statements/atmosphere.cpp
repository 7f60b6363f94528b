// fog{}, rainbow{}, sky_sphere{}, background{} (spec/shading.md 13).
#include <algorithm>

#include "parser/parser.h"
#include "parser/statements/textures.h"
#include "parser/statements/transformations.h"
#include "parser/statements/warp.h"

namespace durer {

std::shared_ptr<const FogNode> parse_fog(Parser& parser) {
  parser.expect_open("fog");
  const auto named = parser.accept_identifier<FogNode>(ValueKind::fog);
  auto fog = named ? std::make_shared<FogNode>(*named) : std::make_shared<FogNode>();
  Transform transform;
  for (;;) {
    if (parser.accept(Keyword::distance)) {
      fog->distance = parser.parse_float();
    } else if (parser.accept(Keyword::fog_type)) {
      fog->type = parser.parse_int();
    } else if (parser.accept(Keyword::fog_alt)) {
      fog->altitude = parser.parse_float();
    } else if (parser.accept(Keyword::fog_offset)) {
      fog->offset = parser.parse_float();
    } else if (parser.accept(Keyword::turb_depth)) {
      fog->turbulence_depth = parser.parse_float();
    } else if (parser.accept(Keyword::up)) {
      fog->up = parser.parse_vector();
    } else if (accept_turbulence_item(parser, fog->turbulence)) {
      fog->has_turbulence = true;
    } else if (accept_transformation(parser, transform)) {
      fog->up = transform.direction(fog->up);
    } else if (parser.at_color_start()) {
      fog->color = parser.parse_color();
    } else if (parser.at_expression()) {
      parser.warning("a fog's distance should follow the word 'distance'");
      fog->distance = parser.parse_float();
    } else {
      break;
    }
  }
  parser.expect_close("fog");
  return fog;
}

std::shared_ptr<const RainbowNode> parse_rainbow(Parser& parser) {
  parser.expect_open("rainbow");
  const auto named = parser.accept_identifier<RainbowNode>(ValueKind::rainbow);
  auto rainbow = named ? std::make_shared<RainbowNode>(*named) : std::make_shared<RainbowNode>();
  if (!named) {
    rainbow->distance = 1e7;
    rainbow->falloff_angle = rainbow->arc_angle = 360;
  }
  bool arc_given = false, falloff_given = false;
  for (;;) {
    if (parser.accept(Keyword::angle)) {
      rainbow->angle = parser.parse_float();
    } else if (parser.accept(Keyword::direction)) {
      rainbow->direction = parser.parse_vector();
    } else if (parser.accept(Keyword::color_map)) {
      rainbow->color_map = parse_color_map(parser);
    } else if (parser.accept(Keyword::distance)) {
      rainbow->distance = parser.parse_float();
    } else if (parser.accept(Keyword::jitter)) {
      rainbow->jitter = parser.parse_float();
    } else if (parser.accept(Keyword::width)) {
      rainbow->width = parser.parse_float();
    } else if (parser.accept(Keyword::up)) {
      rainbow->up = parser.parse_vector();
    } else if (parser.accept(Keyword::falloff_angle)) {
      rainbow->falloff_angle = parser.parse_float();
      falloff_given = true;
    } else if (parser.accept(Keyword::arc_angle)) {
      rainbow->arc_angle = parser.parse_float();
      arc_given = true;
    } else {
      break;
    }
  }
  if (length(rainbow->direction) == 0) parser.error("a rainbow needs a direction");
  if (length(rainbow->up) == 0) parser.error("a rainbow's up must not be the zero vector");
  if (length(cross(rainbow->direction, rainbow->up)) < 1e-10) {
    parser.error("a rainbow's direction and up must not be parallel");
  }
  if (arc_given && !falloff_given) rainbow->falloff_angle = rainbow->arc_angle;
  if (falloff_given && !arc_given) {
    // The limit stays at 180 radians: the fade is spread so far that it hardly shows.
    rainbow->arc_angle = 2 * 180 * (180 / 3.14159265358979323846);
  }
  if (rainbow->arc_angle < rainbow->falloff_angle) {
    parser.error("arc_angle must not be less than falloff_angle");
  }
  parser.expect_close("rainbow");
  return rainbow;
}

std::shared_ptr<const SkySphereNode> parse_sky_sphere(Parser& parser) {
  parser.expect_open("sky_sphere");
  const auto named = parser.accept_identifier<SkySphereNode>(ValueKind::sky_sphere);
  auto sky = named ? std::make_shared<SkySphereNode>(*named) : std::make_shared<SkySphereNode>();
  Transform transform;
  for (;;) {
    if (parser.accept(Keyword::pigment)) {
      // Nothing comes from #default.
      sky->pigments.push_back(parse_pigment(parser, std::make_shared<const PigmentNode>()));
    } else if (parser.accept(Keyword::emission)) {
      sky->emission = parser.parse_rgb();
    } else if (accept_transformation(parser, transform)) {
      sky->transform = sky->transform.then(transform);
    } else {
      break;
    }
  }
  if (sky->pigments.empty()) parser.error("a sky_sphere needs at least one pigment");
  parser.expect_close("sky_sphere");
  return sky;
}

// What remains of filter and transmit depends on version and output (spec/language.md 24).
ColorRGBFT parse_background(Parser& parser) {
  parser.expect_open("background");
  ColorRGBFT color = parser.parse_color();
  parser.expect_close("background");
  const bool alpha = parser.options().output_alpha;
  if (parser.effective_version() < 370) {
    color.filter = 0;
    color.transmit = alpha ? 1.0f : 0.0f;
  } else if (!alpha) {
    const float share = 1 - color.transmit;
    color = {color.red * share, color.green * share, color.blue * share, 0, 0};
  }
  return color;
}

}  // namespace durer
