// The scene level: what may stand outside all braces (spec/language.md 24), and what can be declared.
#include <algorithm>

#include "parser/parser.h"
#include "parser/statements/camera.h"
#include "parser/statements/needless_bounds.h"
#include "parser/statements/objects.h"
#include "parser/statements/statements.h"
#include "parser/statements/textures.h"
#include "parser/statements/transformations.h"
#include "tracer/scene/scene.h"

namespace durer {
namespace {

// An object that has no texture when its outermost statement ends gets the default texture of that
// moment, for itself and its untextured members (spec/language.md 20). It is noted where it changes:
// `noted` is the last one.
ObjectPtr with_default_texture(Parser& parser, ObjectPtr object, TexturePtr& noted) {
  if (noted == default_texture(parser)) return object;
  noted = default_texture(parser);
  return with_modifier(std::move(object), SetDefaultTexture{noted});
}

void add_camera(Parser& parser) {
  Scene& scene = parser.scene();
  // Before 3.5 a further camera changes the one before it.
  auto camera = parse_camera(parser, parser.language_version() < 350 ? scene.camera : nullptr);
  if (!scene.cameras.empty() && parser.language_version() >= 350) {
    parser.warning("the scene has more than one camera; the last one is used");
  }
  scene.cameras.push_back(camera);
  scene.camera = std::move(camera);
}

// One statement. False at the end of the text.
bool parse_statement(Parser& parser, TexturePtr& default_noted, NeedlessBounds& needless_bounds) {
  Scene& scene = parser.scene();
  if (ObjectPtr object = parse_object(parser)) {
    parser.count_in_scene(*object);
    needless_bounds.warn_about(object);
    scene.objects.push_back(with_default_texture(parser, std::move(object), default_noted));
  } else if (parser.accept(Keyword::camera)) {
    add_camera(parser);
  } else if (parser.accept(Keyword::global_settings)) {
    parse_global_settings(parser);
  } else if (parser.accept(Keyword::background)) {
    scene.background = parse_background(parser);
  } else if (parser.accept(Keyword::fog)) {
    scene.fogs.push_back(*parse_fog(parser));
  } else if (parser.accept(Keyword::rainbow)) {
    scene.rainbows.push_back(*parse_rainbow(parser));
  } else if (parser.accept(Keyword::sky_sphere)) {
    if (scene.sky_sphere) parser.warning("the scene has more than one sky_sphere; the last counts");
    scene.sky_sphere = parse_sky_sphere(parser);
  } else if (parser.accept(Keyword::media)) {
    scene.atmosphere.push_back(parse_media(parser));
  } else if (parser.accept_bare_directive()) {
  } else if (parser.accept(Keyword::max_trace_level)) {
    scene.settings.max_trace_level = std::clamp(parser.parse_int(), 1, 256);
    parser.possible_error("max_trace_level belongs into global_settings");
  } else if (parser.accept(Keyword::max_intersections)) {
    parser.parse_float();
    if (parser.language_version() >= 370) {
      parser.warning("max_intersections has no effect any more");
    }
  } else if (parser.accept(Keyword::version)) {
    parser.parse_float();
    parser.note("'version' without '#' ends the scene here, as it does in POV-Ray");
    return false;
  } else if (parser.at_end()) {
    return false;
  } else {
    parser.error_expected("an object or a directive");
  }
  return true;
}

template <typename T>
Value block(ValueKind kind, std::shared_ptr<const T> handle) {
  return Value(kind, std::const_pointer_cast<T>(std::move(handle)));
}

}  // namespace

void parse_scene_statements(Parser& parser) {
  TexturePtr default_noted;
  NeedlessBounds needless_bounds(parser);
  while (parse_statement(parser, default_noted, needless_bounds)) {
  }
  Scene& scene = parser.scene();
  if (!scene.camera) {
    // The built-in one: that of #default is for camera{} statements only.
    scene.camera = std::make_shared<const CameraNode>();
    scene.cameras.push_back(scene.camera);
  }
  scene.default_texture = default_texture(parser);
}

Value parse_rvalue_block(Parser& parser) {
  if (ObjectPtr object = parse_object(parser)) return block(ValueKind::object, object);
  if (parser.accept(Keyword::texture)) {
    TexturePtr texture = layer_texture(parser, nullptr, parse_texture(parser));
    // Several in a row are layers.
    while (parser.accept_before_directives(Keyword::texture)) {
      texture = layer_texture(parser, texture, parse_texture(parser));
    }
    return block(ValueKind::texture, texture);
  }
  if (parser.accept(Keyword::pigment)) {
    return block(ValueKind::pigment, parse_pigment(parser, default_texture(parser)->pigment));
  }
  if (parser.accept(Keyword::normal)) {
    return block(ValueKind::normal, parse_normal(parser, default_texture(parser)->normal));
  }
  if (parser.accept(Keyword::finish)) {
    return block(ValueKind::finish, parse_finish(parser, default_texture(parser)->finish));
  }
  if (parser.accept(Keyword::material)) return block(ValueKind::material, parse_material(parser));
  if (parser.accept(Keyword::interior)) return block(ValueKind::interior, parse_interior(parser));
  if (parser.accept(Keyword::media)) return block(ValueKind::media, parse_media(parser));
  if (parser.accept(Keyword::density)) return block(ValueKind::density, parse_density(parser));
  if (parser.accept(Keyword::color_map)) {
    return block(ValueKind::color_map, parse_color_map(parser));
  }
  if (parser.accept(Keyword::pigment_map)) {
    return block(ValueKind::pigment_map, parse_pigment_map(parser));
  }
  if (parser.accept(Keyword::normal_map)) {
    return block(ValueKind::normal_map, parse_normal_map(parser));
  }
  if (parser.accept(Keyword::slope_map)) {
    return block(ValueKind::slope_map, parse_slope_map(parser));
  }
  if (parser.accept(Keyword::texture_map)) {
    return block(ValueKind::texture_map, parse_texture_map(parser));
  }
  if (parser.accept(Keyword::density_map)) {
    return block(ValueKind::density_map, parse_density_map(parser));
  }
  if (parser.accept(Keyword::transform)) {
    if (auto named = parser.accept_identifier<Transform>(ValueKind::transform)) {
      return block(ValueKind::transform, named);
    }
    return Value(ValueKind::transform, std::make_shared<Transform>(parse_transform_block(parser)));
  }
  if (parser.accept(Keyword::camera)) return block(ValueKind::camera, parse_camera(parser));
  if (parser.accept(Keyword::fog)) return block(ValueKind::fog, parse_fog(parser));
  if (parser.accept(Keyword::rainbow)) return block(ValueKind::rainbow, parse_rainbow(parser));
  if (parser.accept(Keyword::sky_sphere)) {
    return block(ValueKind::sky_sphere, parse_sky_sphere(parser));
  }
  return {};
}

}  // namespace durer
