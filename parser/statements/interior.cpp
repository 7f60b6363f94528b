// interior{}, material{}, media{} (spec/shading.md 11, 14).
#include <algorithm>

#include "parser/parser.h"
#include "parser/statements/textures.h"
#include "parser/statements/transformations.h"
#include "tracer/scene/media.h"

namespace durer {

std::shared_ptr<const InteriorNode> parse_interior(
    Parser& parser, const std::shared_ptr<const InteriorNode>& start) {
  parser.expect_open("interior");
  auto node = start ? std::make_shared<InteriorNode>(*start) : std::make_shared<InteriorNode>();
  if (const auto named = parser.accept_identifier<InteriorNode>(ValueKind::interior)) {
    *node = *named;
  }
  node->position = parser.position();
  auto number = [&] { return static_cast<float>(parser.parse_float()); };
  for (;;) {
    if (parser.accept(Keyword::ior)) {
      node->ior = number();
    } else if (parser.accept(Keyword::dispersion)) {
      node->dispersion = number();
    } else if (parser.accept(Keyword::dispersion_samples)) {
      node->dispersion_samples = parser.parse_int();
      if (node->dispersion_samples < 2) parser.error("dispersion_samples must be at least 2");
    } else if (parser.accept(Keyword::caustics)) {
      node->caustics = number();
    } else if (parser.accept(Keyword::fade_color)) {
      node->fade_color = parser.parse_rgb();
    } else if (parser.accept(Keyword::fade_distance)) {
      node->fade_distance = number();
    } else if (parser.accept(Keyword::fade_power)) {
      node->fade_power = number();
    } else if (parser.accept(Keyword::refraction)) {
      node->refraction = number();
      parser.warning("refraction is on without being asked for; this item is not needed");
    } else if (parser.accept(Keyword::media)) {
      node->media.push_back(parse_media(parser));
    } else {
      break;
    }
  }
  parser.expect_close("interior");
  return node;
}

namespace {

void put_on_top(Parser& parser, TexturePtr& texture, const TexturePtr& top) {
  if (top) texture = layer_texture(parser, texture, top);
}

}  // namespace

std::shared_ptr<const MaterialNode> parse_material(Parser& parser, const MaterialNode& start) {
  parser.expect_open("material");
  auto node = std::make_shared<MaterialNode>(start);
  if (const auto named = parser.accept_identifier<MaterialNode>(ValueKind::material)) {
    put_on_top(parser, node->texture, named->texture);
    put_on_top(parser, node->interior_texture, named->interior_texture);
    node->interior = named->interior;  // also where it has none
  }
  Transform transform;
  for (;;) {
    if (parser.accept(Keyword::texture)) {
      put_on_top(parser, node->texture, parse_texture(parser));
    } else if (parser.accept(Keyword::interior_texture)) {
      put_on_top(parser, node->interior_texture, parse_texture(parser));
    } else if (parser.accept(Keyword::interior)) {
      node->interior = parse_interior(parser, node->interior);
    } else if (accept_transformation(parser, transform)) {
      // The interior texture stays where it is (spec/textures.md 15.2).
      node->texture = transformed(node->texture, transform, PlainColors::move);
      node->interior = transformed(node->interior, transform);
    } else {
      break;
    }
  }
  parser.expect_close("material");
  return node;
}

namespace {

void parse_scattering(Parser& parser, MediaNode& media) {
  parser.expect_open("scattering");
  media.scattering_type = parser.parse_int();
  parser.accept_comma();
  if (media.scattering_type < 1 || media.scattering_type > 5) {
    parser.warning("there are scattering types 1 to 5");
  }
  media.scattering = parser.parse_rgb();
  for (;;) {
    if (parser.accept(Keyword::eccentricity)) {
      if (media.scattering_type != 5) parser.error("only scattering of type 5 has an eccentricity");
      media.eccentricity = static_cast<float>(parser.parse_float());
    } else if (parser.accept(Keyword::extinction)) {
      media.extinction = static_cast<float>(parser.parse_float());
    } else {
      break;
    }
  }
  parser.expect_close("scattering");
}

bool accept_media_item(Parser& parser, MediaNode& media) {
  auto number = [&] { return static_cast<float>(parser.parse_float()); };
  Transform transform;
  if (parser.accept(Keyword::intervals)) {
    media.intervals = parser.parse_int();
    if (media.intervals < 1) parser.error("media needs at least one interval");
  } else if (parser.accept(Keyword::samples)) {
    media.min_samples = parser.parse_int();
    parser.accept_comma();
    media.max_samples = parser.at_expression() ? parser.parse_int() : media.min_samples;
  } else if (parser.accept(Keyword::method)) {
    media.method = parser.parse_int();
    if (media.method < 1 || media.method > 3) parser.error("there are methods 1, 2 and 3");
  } else if (parser.accept(Keyword::jitter)) {
    media.jitter = number();
  } else if (parser.accept(Keyword::aa_threshold)) {
    media.aa_threshold = number();
  } else if (parser.accept(Keyword::aa_level)) {
    media.aa_level = parser.parse_int();
  } else if (parser.accept(Keyword::collect)) {
    media.collect = parser.parse_optional_switch();
  } else if (parser.accept(Keyword::absorption)) {
    media.absorption = parser.parse_rgb();
  } else if (parser.accept(Keyword::emission)) {
    media.emission = parser.parse_rgb();
  } else if (parser.accept(Keyword::scattering)) {
    parse_scattering(parser, media);
  } else if (parser.accept(Keyword::confidence)) {
    media.confidence = number();
    if (!(media.confidence > 0 && media.confidence < 1)) {
      parser.error("confidence must lie between 0 and 1");
    }
  } else if (parser.accept(Keyword::variance)) {
    media.variance = number();
  } else if (parser.accept(Keyword::ratio)) {
    media.ratio = number();
  } else if (parser.accept(Keyword::density)) {
    media.densities.push_back(parse_density(parser));
  } else if (accept_transformation(parser, transform)) {
    for (auto& density : media.densities) density = transformed(density, transform);
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const MediaNode> parse_media(Parser& parser) {
  parser.expect_open("media");
  const auto named = parser.accept_identifier<MediaNode>(ValueKind::media);
  auto media = named ? std::make_shared<MediaNode>(*named) : std::make_shared<MediaNode>();
  media->position = parser.position();
  if (!named && parser.language_version() < 350) {
    media->method = 1;
    media->intervals = 10;
    media->min_samples = media->max_samples = 1;
  }
  while (accept_media_item(parser, *media)) {
  }
  if (media->min_samples < 1) parser.error("media needs at least one sample per interval");
  if (media->max_samples < media->min_samples) {
    parser.error("the most samples per interval are fewer than the least");
  }
  if (media->aa_level < 1) parser.error("aa_level must be at least 1");
  parser.expect_close("media");
  return media;
}

}  // namespace durer
