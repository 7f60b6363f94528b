// Textures, interiors, media and what else surrounds surfaces. Every function that parses a block
// `word{...}` starts after the word, unless it says otherwise.
#pragma once

#include <memory>

#include "tracer/scene/light.h"
#include "tracer/scene/object.h"
#include "tracer/scene/scene.h"

namespace durer {

class Parser;
enum class Keyword : uint16_t;

// pigment{...}: starts from `start` (never null: the default or the object's own).
std::shared_ptr<const PigmentNode> parse_pigment(Parser& parser,
                                                 const std::shared_ptr<const PigmentNode>& start);
// start may be null: no normal yet.
std::shared_ptr<const NormalNode> parse_normal(Parser& parser,
                                               const std::shared_ptr<const NormalNode>& start);
// bump_map{...}: changes the pattern and the size of the bumps.
void parse_bump_map(Parser& parser, NormalNode& normal);
// In #default a normal may say how, but not yet which pattern.
std::shared_ptr<const NormalNode> parse_default_normal(
    Parser& parser, const std::shared_ptr<const NormalNode>& start);
std::shared_ptr<const FinishNode> parse_finish(Parser& parser,
                                               const std::shared_ptr<const FinishNode>& start);
// texture{...}: one statement; may name a layered texture.
TexturePtr parse_texture(Parser& parser);
// `part`: pigment, normal or finish, just read. The texture with that part changed.
TexturePtr parse_texture_part(Parser& parser, Keyword part, const TexturePtr& start);
// The default texture, copied (it is immutable: shared).
TexturePtr default_texture(Parser& parser);
// Puts a texture on top of another (null: of nothing); errors where one is patterned. In scenes up to
// language 3.1 what lies above a layer filters no more, also in a stack that is given to an object or
// declared anew as it is (measured on povray 3.7).
TexturePtr layer_texture(Parser& parser, const TexturePtr& below, const TexturePtr& top);

// `start`: what the object has already; null: nothing.
std::shared_ptr<const InteriorNode> parse_interior(
    Parser& parser, const std::shared_ptr<const InteriorNode>& start = nullptr);
std::shared_ptr<const MaterialNode> parse_material(Parser& parser, const MaterialNode& start = {});
std::shared_ptr<const MediaNode> parse_media(Parser& parser);
std::shared_ptr<const PigmentNode> parse_density(Parser& parser);

// Maps: color_map{...} etc. The entries of average have weights, which may be left out.
enum class MapEntries : uint8_t { places, weights };
std::shared_ptr<const ColorMap> parse_color_map(Parser& parser);
// The colours of a list pattern; those left out come from the default list.
std::shared_ptr<const ColorMap> parse_color_list(Parser& parser, const PatternNode& pattern);
std::shared_ptr<const PigmentMap> parse_pigment_map(Parser& parser,
                                                    MapEntries entries = MapEntries::places);
std::shared_ptr<const NormalMap> parse_normal_map(Parser& parser,
                                                    MapEntries entries = MapEntries::places);
std::shared_ptr<const SlopeMap> parse_slope_map(Parser& parser);
std::shared_ptr<const TextureMap> parse_texture_map(Parser& parser,
                                                    MapEntries entries = MapEntries::places);
std::shared_ptr<const PigmentMap> parse_density_map(Parser& parser,
                                                    MapEntries entries = MapEntries::places);

// [type] file [gamma ...] [premultiplied ...]
enum class ImageUse { pattern, height_field };
std::shared_ptr<ImageSource> parse_image_file(Parser& parser, ImageUse use);
// The same with the options that this kind of image pattern takes, up to the closing brace.
// bump_size is an option of bump_map only; null elsewhere.
std::shared_ptr<const ImageSource> parse_image_options(Parser& parser, PatternKind kind,
                                                       float* bump_size = nullptr);

std::shared_ptr<const FogNode> parse_fog(Parser& parser);
std::shared_ptr<const RainbowNode> parse_rainbow(Parser& parser);
std::shared_ptr<const SkySphereNode> parse_sky_sphere(Parser& parser);
ColorRGBFT parse_background(Parser& parser);
void parse_global_settings(Parser& parser);

PhotonSettings parse_object_photons(Parser& parser);
LightPhotons parse_light_photons(Parser& parser);
double parse_radiosity_importance(Parser& parser);

}  // namespace durer
