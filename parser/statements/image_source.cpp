// image_map, bump_map, image_pattern, material_map: file and options (spec/textures.md 12.1).
#include <cmath>

#include "parser/parser.h"
#include "parser/statements/textures.h"
#include "tracer/functions/compiled_function.h"
#include "tracer/image/raster_file.h"
#include "tracer/scene/function.h"

namespace durer {
namespace {

ImageFileType accept_type(Parser& parser) {
  struct Word {
    Keyword keyword;
    ImageFileType type;
  };
  static constexpr Word kWords[] = {
      {Keyword::tga, ImageFileType::tga},   {Keyword::png, ImageFileType::png},
      {Keyword::ppm, ImageFileType::ppm},   {Keyword::pgm, ImageFileType::pgm},
      {Keyword::gif, ImageFileType::gif},   {Keyword::iff, ImageFileType::iff},
      {Keyword::jpeg, ImageFileType::jpeg}, {Keyword::tiff, ImageFileType::tiff},
      {Keyword::bmp, ImageFileType::bmp},   {Keyword::exr, ImageFileType::exr},
      {Keyword::hdr, ImageFileType::hdr},   {Keyword::pot, ImageFileType::pot},
  };
  for (const Word& word : kWords) {
    if (parser.accept(word.keyword)) return word.type;
  }
  return ImageFileType::by_name;
}

void parse_index_or_all(Parser& parser, const ImageSource& source,
                        std::vector<std::pair<int, float>>& list) {
  int index = ImageSource::kAllIndices;
  if (!parser.accept(Keyword::all)) {
    index = parser.parse_int();
    parser.accept_comma();
    const size_t entries = source.raster ? source.raster->palette.size() : 0;
    if (entries == 0) parser.error("an image without a palette knows `all` only");
    if (index < 0 || static_cast<size_t>(index) >= entries) {
      parser.error("the palette has entries 0 to " + std::to_string(entries - 1));
    }
  }
  list.emplace_back(index, static_cast<float>(parser.parse_float()));
}

ImageInterpolation parse_interpolation(Parser& parser, bool strict) {
  const int kind = parser.parse_int();
  if (strict && (kind < 2 || kind > 4)) parser.error("there are interpolations 2, 3 and 4");
  return kind >= 2 && kind <= 4 ? static_cast<ImageInterpolation>(kind)
                                : ImageInterpolation::none;
}

ImageMapType parse_map_type(Parser& parser, bool strict) {
  const int kind = parser.parse_int();
  if (kind == 1 || kind == 2 || kind == 5) return static_cast<ImageMapType>(kind);
  if (kind != 0 && strict) parser.error("there are map types 0, 1, 2 and 5");
  return ImageMapType::planar;
}

// Kept as the low 16 bits of value * 65535, not clamped (spec/functions.md 9).
uint16_t stored_value(double value) {
  const float scaled = static_cast<float>(value) * 65535.0f;
  if (!std::isfinite(scaled)) return 0;
  return static_cast<uint16_t>(static_cast<int64_t>(scaled) & 0xFFFF);
}

std::shared_ptr<const FunctionRaster> parse_function_raster(Parser& parser) {
  auto raster = std::make_shared<FunctionRaster>();
  const double width = parser.parse_float();
  parser.accept_comma();
  const double height = parser.parse_float();
  if (!(width >= 0.5 && height >= 0.5 && width * height < 1e9)) {
    parser.error("an image needs at least one pixel, and at most a billion");
  }
  raster->width = static_cast<int>(width + 0.5);
  raster->height = static_cast<int>(height + 0.5);
  const auto function = parser.parse_function(FunctionParameters::xyz, FunctionBodies::any);
  const CompiledFunction& compiled = *function->compiled;
  if (compiled.is_vector() && compiled.kind() != FunctionKind::pigment) {
    parser.error("an image can be made of a number or of a pigment only");
  }
  raster->channels = compiled.is_vector() ? 4 : 1;
  raster->values.reserve(static_cast<size_t>(raster->width) * raster->height * raster->channels);
  for (int row = 0; row < raster->height; ++row) {
    for (int column = 0; column < raster->width; ++column) {
      const double arguments[3] = {static_cast<double>(column) / (raster->width - 1),
                                   static_cast<double>(row) / (raster->height - 1), 0};
      if (!compiled.is_vector()) {
        raster->values.push_back(stored_value(compiled.value(
            Vec3(arguments[0], arguments[1], arguments[2]))));
        continue;
      }
      double color[5];
      compiled.evaluate(arguments, color);
      for (int i = 0; i < 3; ++i) raster->values.push_back(stored_value(color[i]));
      raster->values.push_back(stored_value(1 - color[4]));
    }
  }
  return raster;
}

}  // namespace

std::shared_ptr<ImageSource> parse_image_file(Parser& parser, ImageUse use) {
  auto source = std::make_shared<ImageSource>();
  if (parser.accept(Keyword::function)) {
    source->type = ImageFileType::function;
    source->function = parse_function_raster(parser);
    return source;
  }
  const bool system_kind = parser.accept(Keyword::sys);
  if (!system_kind) source->type = accept_type(parser);
  const std::string name = parser.parse_path_string();
  if (system_kind) {
    parser.error("this system has no kind of images of its own, which `sys` means",
                 "on Windows it is bmp");
  }
  if (source->type == ImageFileType::pot && use != ImageUse::height_field) {
    parser.error("a pot file gives heights, only a height_field can read it");
  }
  source->path = parser.find_image(name, source->type);
  if (source->path.empty()) {
    parser.at_expression();  // POV-Ray looks for the file when it has read the next word: its line counts
    parser.error("the image '" + name + "' is not found");
  }
  for (;;) {
    if (parser.accept(Keyword::gamma)) {
      if (parser.accept(Keyword::srgb)) {
        source->gamma_kind = ImageGamma::srgb;
      } else {
        source->gamma_kind = ImageGamma::power;
        source->gamma = parser.parse_float();
        if (!(source->gamma > 0)) parser.error("gamma must be positive");
      }
    } else if (parser.accept(Keyword::premultiplied)) {
      source->premultiplied = parser.parse_float() > 0;
    } else {
      source->raster = parser.read_image(source->path, source->type);
      return source;
    }
  }
}

std::shared_ptr<const ImageSource> parse_image_options(Parser& parser, PatternKind kind,
                                                       float* bump_size) {
  const bool pigment = kind == PatternKind::image_map;
  // The old syntax gave the map type and the plane of the image here; neither has an effect any more.
  if (!parser.at(Keyword::function) && !parser.at(Symbol::less) && parser.at_expression()) {
    parser.warning("a map type in front of the image has no effect any more; map_type behind it has");
    parser.parse_float();
  }
  if (parser.at(Symbol::less)) {
    parser.warning("the plane of an image has no effect any more");
    parser.parse_vector();
  }
  const auto source = parse_image_file(parser, ImageUse::pattern);
  for (;;) {
    if (parser.accept(Keyword::map_type)) {
      source->map_type = parse_map_type(parser, pigment);
    } else if (parser.accept(Keyword::interpolate)) {
      source->interpolation = parse_interpolation(parser, pigment);
    } else if (parser.accept(Keyword::once)) {
      source->once = true;
    } else if (parser.accept(Keyword::repeat)) {
      source->repeat = parser.parse_uv();
      if (source->repeat.x <= 0 || source->repeat.y <= 0) parser.error("repeat must be positive");
    } else if (parser.accept(Keyword::offset)) {
      source->offset = parser.parse_uv();
    } else if (pigment && parser.accept(Keyword::filter)) {
      parse_index_or_all(parser, *source, source->filter);
    } else if (pigment && parser.accept(Keyword::transmit)) {
      parse_index_or_all(parser, *source, source->transmit);
    } else if (kind == PatternKind::image_pattern && parser.accept(Keyword::use_alpha)) {
      source->use_alpha = true;
    } else if (bump_size && parser.accept(Keyword::bump_size)) {
      *bump_size = static_cast<float>(parser.parse_float());
    } else if (parser.accept(Keyword::use_color)) {
      source->use_color = true;
      source->use_index = false;
    } else if (parser.accept(Keyword::use_index)) {
      source->use_index = true;
      source->use_color = false;
    } else {
      return source;
    }
  }
}

}  // namespace durer
