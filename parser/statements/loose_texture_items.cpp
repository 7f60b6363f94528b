#include "parser/statements/loose_texture_items.h"

#include <algorithm>

#include "parser/parser.h"
#include "parser/statements/pattern.h"
#include "parser/statements/textures.h"
#include "parser/statements/warp.h"

namespace durer {
namespace {

using K = PatternKind;

// The patterns that there were before language 3.0, and three that povray reads here all the same.
bool is_loose_pattern(Keyword word) {
  static constexpr Keyword kWords[] = {
      Keyword::agate,   Keyword::bozo,    Keyword::checker, Keyword::gradient,   Keyword::granite,
      Keyword::hexagon, Keyword::leopard, Keyword::mandel,  Keyword::marble,     Keyword::onion,
      Keyword::spotted, Keyword::square,  Keyword::wood,    Keyword::triangular, Keyword::image_map,
  };
  return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

bool is_loose_bumps(Keyword word) {
  static constexpr Keyword kWords[] = {Keyword::bumps, Keyword::dents, Keyword::ripples,
                                       Keyword::waves, Keyword::wrinkles};
  return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

struct FinishNumber {
  Keyword word;
  float FinishNode::*member;
  bool is_interior = false;  // what belongs into interior{} since version 3.1
};
constexpr FinishNumber kFinishNumbers[] = {
    {Keyword::diffuse, &FinishNode::diffuse},
    {Keyword::brilliance, &FinishNode::brilliance},
    {Keyword::phong, &FinishNode::phong},
    {Keyword::phong_size, &FinishNode::phong_size},
    {Keyword::specular, &FinishNode::specular},
    {Keyword::roughness, &FinishNode::roughness},
    {Keyword::crand, &FinishNode::crand},
    {Keyword::ior, &FinishNode::legacy_ior, true},
    {Keyword::refraction, &FinishNode::legacy_refraction, true},
};

// The texture and one of its parts, both copied, so that they can be changed.
template <typename Node>
Node& edit(TexturePtr& texture, std::shared_ptr<const Node> TextureNode::*part) {
  auto copy = std::make_shared<TextureNode>(*texture);
  auto node = (*copy).*part ? std::make_shared<Node>(*((*copy).*part)) : std::make_shared<Node>();
  Node& result = *node;
  (*copy).*part = std::move(node);
  texture = std::move(copy);
  return result;
}

}  // namespace

bool LooseTextureItems::accept(TexturePtr& texture) {
  return accept_pigment_item(texture) || accept_normal_item(texture) || accept_finish_item(texture);
}

void LooseTextureItems::finish(const TextureNode& texture) const {
  if (texture.pigment->is_unspecified && parser_.language_version() >= 150) {
    parser_.error_expected("a pigment (which language versions 1.5 to 2.99 demand of a texture)");
  }
  if (changed_waves_ && texture.normal->pattern->kind == K::none) {
    parser_.error("frequency and phase belong to the normal here, which has no pattern");
  }
}

void LooseTextureItems::warn(const char* statement) {
  if (parser_.language_version() < 150) {
    parser_.warning(std::string("this item belongs into ") + statement + "{} since version 2");
  }
}

bool LooseTextureItems::accept_pigment_item(TexturePtr& texture) {
  if (parser_.at_color_start()) {
    warn("pigment");
    PigmentNode& pigment = edit(texture, &TextureNode::pigment);
    pigment.color = parser_.parse_color();
    // What the pattern had besides its kind is there for a pattern that follows.
    pigment.pattern.edit().kind = K::none;
    pigment.is_unspecified = false;
    return true;
  }
  if (parser_.peek().kind != TokenKind::keyword) return false;
  if (is_loose_pattern(parser_.peek().keyword)) {
    warn("pigment");
    return accept_pattern(edit(texture, &TextureNode::pigment));
  }
  if (parser_.accept(Keyword::color_map)) {
    warn("pigment");
    auto map = parse_color_map(parser_);
    edit(texture, &TextureNode::pigment).maps = PigmentMaps{.color_map = std::move(map)};
  } else if (parser_.accept(Keyword::quick_color)) {
    warn("pigment");
    const ColorRGBFT color = parser_.parse_color();
    edit(texture, &TextureNode::pigment).quick_color = std::optional(color);
  } else if (parser_.at_any(
                 {Keyword::turbulence, Keyword::octaves, Keyword::omega, Keyword::lambda})) {
    PatternNode& pattern = edit(texture, &TextureNode::pigment).pattern.edit();
    accept_turbulence_item(parser_, pattern.turbulence);
    pattern.has_turbulence = true;
  } else {
    return false;
  }
  return true;
}

// A pattern alone. Its wave, and its frequency unless it has a list, stay what they were: wood and
// marble are ramps here.
bool LooseTextureItems::accept_pattern(PigmentNode& pigment) {
  PatternNode& pattern = pigment.pattern.edit();
  const WaveKind wave = pattern.wave;
  const float frequency = pattern.frequency;
  durer::accept_pattern(parser_, pattern, PatternUse::pigment);
  pattern.wave = wave;
  if (list_length(pattern.kind) == 0 && pattern.kind != K::image_map) pattern.frequency = frequency;
  if (pattern.kind == K::mandel) {
    // 0 inside and outside, as povray 3.7 shows it in this form.
    pattern.fractal.exterior_type = pattern.fractal.interior_type = 0;
    pattern.fractal.exterior_factor = pattern.fractal.interior_factor = 0;
  }
  pigment.is_unspecified = false;
  if (list_length(pattern.kind) > 0) {
    pigment.maps = PigmentMaps{.color_map = parse_color_list(parser_, pattern)};
  }
  return true;
}

NormalNode& LooseTextureItems::edit_normal(TexturePtr& texture) {
  if (!owns_normal_) {
    auto copy = std::make_shared<TextureNode>(*texture);
    copy->normal = default_texture(parser_)->normal;
    texture = std::move(copy);
    owns_normal_ = true;
  }
  return edit(texture, &TextureNode::normal);
}

bool LooseTextureItems::accept_normal_item(TexturePtr& texture) {
  if (parser_.peek().kind != TokenKind::keyword) return false;
  if (const Keyword word = parser_.peek().keyword; is_loose_bumps(word)) {
    warn("normal");
    parser_.next();
    const float amount = static_cast<float>(parser_.parse_float());
    NormalNode& normal = edit_normal(texture);
    normal.pattern.edit().kind = simple_pattern(word);
    normal.bump_size = amount;
  } else if (parser_.accept(Keyword::bump_map)) {
    warn("normal");
    parse_bump_map(parser_, edit_normal(texture));
  } else if (parser_.accept(Keyword::frequency)) {
    warn("normal");
    const float frequency = static_cast<float>(parser_.parse_float());
    edit_normal(texture).pattern.edit().frequency = frequency;
    changed_waves_ = true;
  } else if (parser_.accept(Keyword::phase)) {
    warn("normal");
    const float phase = static_cast<float>(parser_.parse_float());
    edit_normal(texture).pattern.edit().phase = phase;
    changed_waves_ = true;
  } else {
    return false;
  }
  return true;
}

bool LooseTextureItems::accept_finish_item(TexturePtr& texture) {
  if (parser_.accept(Keyword::ambient)) {
    warn("finish");
    const double ambient = parser_.parse_float();
    edit(texture, &TextureNode::finish).ambient = RGB(static_cast<float>(ambient));
    return true;
  }
  if (parser_.accept(Keyword::reflection)) {
    warn("finish");
    const RGB reflection(static_cast<float>(parser_.parse_float()));
    FinishNode& finish = edit(texture, &TextureNode::finish);
    finish.reflection_min = finish.reflection_max = reflection;
    return true;
  }
  if (parser_.accept(Keyword::metallic)) {
    warn("finish");
    edit(texture, &TextureNode::finish).metallic = 1;
    return true;
  }
  for (const FinishNumber& number : kFinishNumbers) {
    if (!parser_.accept(number.word)) continue;
    warn(number.is_interior ? "interior" : "finish");
    const float value = static_cast<float>(parser_.parse_float());
    if (number.is_interior) parser_.warning("this item belongs into interior{} since version 3.1");
    edit(texture, &TextureNode::finish).*number.member = value;
    return true;
  }
  // A number alone is the grain, as in version 1.0.
  if (parser_.at_expression()) {
    const float grain = static_cast<float>(parser_.parse_float());
    if (parser_.language_version() >= 150) parser_.warning("this number is the finish's crand");
    edit(texture, &TextureNode::finish).crand = grain;
    return true;
  }
  return false;
}

}  // namespace durer
