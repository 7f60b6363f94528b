// #default{} (spec/language.md 20), and the photons{} and radiosity{} blocks of objects and lights.
#include "parser/parser.h"
#include "parser/statements/camera.h"
#include "parser/statements/statements.h"
#include "parser/statements/textures.h"
#include "tracer/scene/scene.h"

namespace durer {

void parse_default_block(Parser& parser) {
  parser.expect_open("default");
  parser.in_default_block = true;
  for (;;) {
    TexturePtr& current = parser.scene().default_texture;
    auto edited = std::make_shared<TextureNode>(*default_texture(parser));
    if (parser.accept(Keyword::texture)) {
      const TexturePtr texture = parse_texture(parser);
      if (texture->kind != TextureNode::Kind::plain) {
        parser.error("the default texture must be plain, without pattern or material map");
      }
      if (texture->below) parser.error("the default texture must not be layered");
      current = texture;
    } else if (parser.accept(Keyword::pigment)) {
      edited->pigment = parse_pigment(parser, edited->pigment);
      current = edited;
    } else if (parser.accept(Keyword::normal)) {
      edited->normal = parse_default_normal(parser, edited->normal);
      current = edited;
    } else if (parser.accept(Keyword::finish)) {
      edited->finish = parse_finish(parser, edited->finish);
      current = edited;
    } else if (parser.accept(Keyword::radiosity)) {
      parser.scene().settings.radiosity_default_importance = parse_radiosity_importance(parser);
    } else if (parser.accept(Keyword::camera)) {
      parser.default_camera = parse_camera(parser);
    } else {
      break;
    }
  }
  parser.in_default_block = false;
  parser.expect_close("default");
}

double parse_radiosity_importance(Parser& parser) {
  parser.expect_open("radiosity");
  double importance = 1;
  while (parser.accept(Keyword::importance)) {
    importance = parser.parse_float();
    if (!(importance > 0 && importance <= 1)) {
      parser.error("importance must lie above 0 and not above 1");
    }
  }
  parser.expect_close("radiosity");
  return importance;
}

// Of target, pass_through and refraction two may hold (spec/gi.md A1.2).
PhotonSettings parse_object_photons(Parser& parser) {
  PhotonSettings photons;
  auto conflict = [&] {
    return photons.pass_through.value_or(false) && photons.target &&
           photons.refraction.value_or(true);
  };
  parser.expect_open("photons");
  for (;;) {
    if (parser.accept(Keyword::target)) {
      const double spacing = parser.parse_optional_float(1);
      photons.target.reset();
      if (spacing > 0) photons.target = spacing;
      if (conflict()) {
        if (photons.refraction.value_or(false)) {
          photons.pass_through = false;
        } else {
          photons.refraction = false;
        }
        parser.warning("a target with pass_through cannot refract photons, too");
      }
    } else if (parser.accept(Keyword::refraction)) {
      photons.refraction = parser.parse_int() != 0;
      if (*photons.refraction && conflict()) {
        photons.pass_through = false;
        parser.warning("refraction of photons switches pass_through off");
      }
    } else if (parser.accept(Keyword::reflection)) {
      photons.reflection = parser.parse_int() != 0;
    } else if (parser.accept(Keyword::pass_through)) {
      photons.pass_through = parser.parse_optional_float(1) != 0;
      if (conflict()) {
        photons.refraction = false;
        parser.warning("pass_through switches the refraction of photons off");
      }
    } else if (parser.accept(Keyword::collect)) {
      photons.collect = parser.parse_optional_float(1) != 0;
    } else {
      break;
    }
  }
  parser.expect_close("photons");
  return photons;
}

LightPhotons parse_light_photons(Parser& parser) {
  LightPhotons photons;
  parser.expect_open("photons");
  for (;;) {
    if (parser.accept(Keyword::refraction)) {
      photons.refraction = parser.parse_int() != 0;
    } else if (parser.accept(Keyword::reflection)) {
      photons.reflection = parser.parse_int() != 0;
    } else if (parser.accept(Keyword::area_light)) {
      photons.area_light = true;
    } else {
      break;
    }
  }
  parser.expect_close("photons");
  return photons;
}

}  // namespace durer
