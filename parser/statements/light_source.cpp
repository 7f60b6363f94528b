// light_source (spec/shading.md 9).
#include <cmath>

#include "parser/parser.h"
#include "parser/statements/objects.h"
#include "parser/statements/textures.h"
#include "parser/statements/transformations.h"

namespace durer {
namespace {

constexpr double kEpsilon = 1e-10;

void parse_area(Parser& parser, LightNode& light) {
  light.area = true;
  light.axis1 = parser.parse_vector();
  parser.accept_comma();
  light.axis2 = parser.parse_vector();
  parser.accept_comma();
  light.size1 = parser.parse_int();
  parser.accept_comma();
  light.size2 = parser.parse_int();
  if (light.size1 < 1 || light.size2 < 1) {
    parser.error("an area light needs at least one sample in each direction");
  }
}

// The object is moved to where the light stands so far.
ObjectPtr parse_looks_like(Parser& parser, const Vec3& location) {
  parser.expect_open("looks_like");
  const ObjectPtr inner = require_object(parser);
  ObjectBuilder builder(parser, inner);
  builder.add(Transform::translation(location));
  builder.add(SetFlag{ObjectFlag::no_shadow, true});
  return builder.finish("looks_like");
}

ObjectPtr parse_projected_through(Parser& parser) {
  parser.expect_open("projected_through");
  const ObjectPtr inner = require_object(parser);
  ObjectBuilder builder(parser, inner);
  ObjectPtr object = builder.finish("projected_through");
  // Only its form counts.
  const ResolvedTextures surface = resolve_textures(*object);
  if (surface.interior) parser.warning("the interior of a projected_through object has no effect");
  if (surface.texture) parser.warning("the texture of a projected_through object has no effect");
  return object;
}

void transform_light(LightNode& light, const Transform& t) {
  light.location = t.point(light.location);
  light.point_at = t.point(light.point_at);
  light.axis1 = t.direction(light.axis1);
  light.axis2 = t.direction(light.axis2);
  for (ObjectPtr* object : {&light.looks_like, &light.projected_through}) {
    if (*object) *object = with_modifier(std::move(*object), t);
  }
}

class LightReader {
 public:
  LightReader(Parser& parser, LightNode& light) : parser_(parser), light_(light) {}

  bool accept_item() {
    Transform transform;
    if (accept_transformation(parser_, transform)) {
      transform_light(light_, transform);
      return true;
    }
    return accept_kind() || accept_cone_item() || accept_area_item() || accept_other();
  }

 private:
  bool accept_kind() {
    if (parser_.accept(Keyword::spotlight)) {
      light_.kind = LightKind::spot;
      light_.shadowless = false;
      light_.radius = 30;
      light_.falloff = 45;
      light_.tightness = 0;
    } else if (parser_.accept(Keyword::cylinder)) {
      light_.kind = LightKind::cylinder;
      light_.parallel = true;  // and stays so if another kind follows
      light_.shadowless = false;
      light_.radius = 0.75;
      light_.falloff = 1;
      light_.tightness = 0;
    } else if (parser_.accept(Keyword::shadowless)) {
      light_.shadowless = true;
      light_.kind = LightKind::point;
    } else if (parser_.accept(Keyword::parallel)) {
      light_.parallel = true;
    } else {
      return false;
    }
    return true;
  }

  bool accept_cone_item() {
    const bool cone = light_.kind == LightKind::spot || light_.kind == LightKind::cylinder;
    if (parser_.at(Keyword::point_at)) {
      if (!cone && !light_.parallel) {
        parser_.error("point_at needs spotlight, cylinder or parallel before it");
      }
      parser_.next();
      light_.point_at = parser_.parse_vector();
    } else if (parser_.at_any({Keyword::radius, Keyword::falloff, Keyword::tightness})) {
      if (!cone) parser_.error("this item needs spotlight or cylinder before it");
      if (parser_.accept(Keyword::radius)) {
        light_.radius = parser_.parse_float();
        light_.radius_given = true;
      } else if (parser_.accept(Keyword::falloff)) {
        light_.falloff = parser_.parse_float();
        light_.falloff_given = true;
      } else {
        parser_.next();
        light_.tightness = parser_.parse_float();
        light_.tightness_given = true;
      }
    } else {
      return false;
    }
    return true;
  }

  bool accept_area_item() {
    if (parser_.accept(Keyword::area_light)) {
      parse_area(parser_, light_);
    } else if (parser_.accept(Keyword::adaptive)) {
      light_.adaptive = parser_.parse_int();
    } else if (parser_.accept(Keyword::jitter)) {
      light_.jitter = true;
    } else if (parser_.accept(Keyword::circular)) {
      light_.circular = true;
      if (!light_.area) parser_.warning("circular has a meaning for area lights only");
    } else if (parser_.accept(Keyword::orient)) {
      light_.orient = true;
      if (!light_.area) parser_.warning("orient has a meaning for area lights only");
    } else if (parser_.accept(Keyword::area_illumination)) {
      light_.area_illumination = parser_.parse_optional_switch();
      if (!light_.area) parser_.warning("area_illumination has a meaning for area lights only");
    } else {
      return false;
    }
    return true;
  }

  bool accept_other() {
    if (parser_.accept(Keyword::fade_distance)) {
      light_.fade_distance = parser_.parse_float();
    } else if (parser_.accept(Keyword::fade_power)) {
      light_.fade_power = parser_.parse_float();
    } else if (parser_.accept(Keyword::media_interaction)) {
      light_.media_interaction = parser_.parse_optional_switch();
    } else if (parser_.accept(Keyword::media_attenuation)) {
      light_.media_attenuation = parser_.parse_optional_switch();
    } else if (parser_.accept(Keyword::looks_like)) {
      if (light_.looks_like) parser_.error("a light can look like one object only");
      light_.looks_like = parse_looks_like(parser_, light_.location);
    } else if (parser_.accept(Keyword::projected_through)) {
      if (light_.projected_through) parser_.error("a light shines through one object only");
      light_.projected_through = parse_projected_through(parser_);
    } else if (parser_.accept(Keyword::photons)) {
      light_.photons = parse_light_photons(parser_);
    } else {
      return false;
    }
    return true;
  }

  Parser& parser_;
  LightNode& light_;
};

// What the items mean together.
void check(Parser& parser, LightNode& light) {
  if (light.circular && (light.size1 <= 1 || light.size2 <= 1)) {
    parser.error("a circular area light needs more than one sample each way");
  }
  if (light.orient) {
    if (!light.circular) parser.warning("orient makes the area light circular, too");
    if (light.size1 != light.size2) {
      parser.warning("an oriented area light should have as many samples one way as the other");
    }
    if (std::abs(length(light.axis1) - length(light.axis2)) > kEpsilon) {
      parser.warning("the axes of an oriented area light should be equally long");
    }
    light.circular = light.size1 > 1 && light.size2 > 1;
    if (!light.circular) {
      parser.warning("a circular area light needs more than one sample each way");
    }
  }
  if (light.kind == LightKind::cylinder) light.parallel = true;
}

// `colour_map` in a light: the sum of its entries, each times its place.
RGB parse_light_color(Parser& parser) {
  if (parser.accept(Keyword::color_map)) {
    const auto map = parse_color_map(parser);
    RGB sum(0.0f);
    for (const auto& entry : map->entries) sum += entry.item.rgb() * entry.position;
    return sum;
  }
  return parser.parse_rgb();
}

}  // namespace

ObjectPtr parse_light_source(Parser& parser) {
  parser.expect_open("light_source");
  if (const auto named = parser.accept_identifier<ObjectNode>(ValueKind::object)) {
    if (const auto* light = std::get_if<std::shared_ptr<const LightNode>>(&shape_of(*named))) {
      // A copy of a light: further items change the copy.
      LightNode copy = **light;
      for (const ObjectNode* node = named.get(); node; node = node->base.get()) {
        for (const Modifier& modifier : node->modifiers) {
          if (const auto* t = std::get_if<Rare<Transform>>(&modifier)) transform_light(copy, *t);
        }
      }
      LightReader reader(parser, copy);
      while (reader.accept_item()) {
      }
      check(parser, copy);
      parser.expect_close("light_source");
      auto node = std::make_shared<ObjectNode>();
      node->position = parser.position();
      node->shape = std::make_shared<const ShapeNode>(
          std::make_shared<const LightNode>(std::move(copy)));
      parser.check_nesting(*node);
      return node;
    }
    ObjectBuilder builder(parser, named);
    return builder.finish("light_source");
  }
  LightNode light;
  light.position = parser.position();
  light.location = parser.parse_vector();
  parser.accept_comma();
  light.color = parse_light_color(parser);
  LightReader reader(parser, light);
  while (reader.accept_item()) {
  }
  check(parser, light);
  parser.expect_close("light_source");
  auto node = std::make_shared<ObjectNode>();
  node->position = light.position;
  node->shape =
      std::make_shared<const ShapeNode>(std::make_shared<const LightNode>(std::move(light)));
  parser.check_nesting(*node);
  return node;
}

}  // namespace durer
