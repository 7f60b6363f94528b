// finish{} (spec/shading.md 8, 17).
#include <cmath>

#include "parser/parser.h"
#include "parser/statements/textures.h"
#include "tracer/scene/node_memory.h"

namespace durer {
namespace {

class FinishReader {
 public:
  FinishReader(Parser& parser, FinishNode& finish) : parser_(parser), finish_(finish) {}

  void read() {
    while (accept_color_item() || accept_number() || accept_block() || accept_legacy()) {
    }
    if (parser_.accept(Keyword::fresnel)) {
      parser_.error(
          "'fresnel' outside of 'reflection { }' is syntax of POV-Ray 3.8, and this program "
          "reads the language of version 3.7");
    }
    apply_albedo();
  }

 private:
  float number() { return static_cast<float>(parser_.parse_float()); }

  bool accept_color_item() {
    if (parser_.accept(Keyword::ambient)) {
      finish_.ambient = parser_.parse_rgb();
    } else if (parser_.accept(Keyword::emission)) {
      finish_.emission = parser_.parse_rgb();
    } else {
      return false;
    }
    return true;
  }

  bool accept_number() {
    if (parser_.accept(Keyword::diffuse)) {
      if (parser_.accept(Keyword::albedo)) albedo_diffuse_ = true;
      finish_.diffuse = number();
      finish_.diffuse_back = 0;
      parser_.accept_comma();
      if (parser_.at_expression()) {
        finish_.diffuse_back = number();
        parser_.note_experimental("backside illumination");
      }
    } else if (parser_.accept(Keyword::brilliance)) {
      finish_.brilliance = number();
    } else if (parser_.accept(Keyword::phong)) {
      if (parser_.accept(Keyword::albedo)) albedo_phong_ = true;
      finish_.phong = number();
    } else if (parser_.accept(Keyword::phong_size)) {
      finish_.phong_size = number();
    } else if (parser_.accept(Keyword::specular)) {
      if (parser_.accept(Keyword::albedo)) albedo_specular_ = true;
      finish_.specular = number();
    } else if (parser_.accept(Keyword::roughness)) {
      finish_.roughness = number();
      if (finish_.roughness == 0) parser_.warning("a roughness of 0 makes no sense");
    } else if (parser_.accept(Keyword::metallic)) {
      finish_.metallic = static_cast<float>(parser_.parse_optional_float(1));
    } else if (parser_.accept(Keyword::crand)) {
      finish_.crand = number();
    } else if (parser_.accept(Keyword::conserve_energy)) {
      finish_.conserve_energy = true;
    } else if (parser_.accept(Keyword::reflection_exponent)) {
      finish_.reflection_exponent = number();
    } else {
      return false;
    }
    return true;
  }

  bool accept_block() {
    if (parser_.accept(Keyword::reflection)) {
      parse_reflection();
    } else if (parser_.accept(Keyword::irid)) {
      parser_.expect_open("irid");
      finish_.irid.amount = number();
      for (;;) {
        if (parser_.accept(Keyword::thickness)) {
          finish_.irid.thickness = number();
        } else if (parser_.accept(Keyword::turbulence)) {
          finish_.irid.turbulence = static_cast<float>(parser_.parse_vector().x);
        } else {
          break;
        }
      }
      parser_.expect_close("irid");
    } else if (parser_.accept(Keyword::subsurface)) {
      parser_.note_experimental("subsurface light transport");
      parser_.expect_open("subsurface");
      finish_.has_subsurface = true;
      for (;;) {
        if (parser_.accept(Keyword::translucency)) {
          finish_.subsurface_translucency = parser_.parse_rgb();
        } else if (parser_.accept(Keyword::anisotropy)) {
          finish_.subsurface_anisotropy = parser_.parse_rgb();
        } else {
          break;
        }
      }
      parser_.expect_close("subsurface");
    } else {
      return false;
    }
    return true;
  }

  // What an earlier block, or the finish that is copied, said goes on where this one says nothing; the
  // form without braces ends fresnel and falloff (measured on povray 3.7).
  void parse_reflection() {
    if (!parser_.accept(Symbol::brace_open)) {
      finish_.reflection_max = finish_.reflection_min = parser_.parse_rgb();
      finish_.reflection_fresnel = false;
      finish_.reflection_falloff = 1;
      return;
    }
    bool two_colors = false, from_zero = false;
    finish_.reflection_max = parser_.parse_rgb();
    parser_.accept_comma();
    if (parser_.at_color_or_expression()) {
      finish_.reflection_min = finish_.reflection_max;
      finish_.reflection_max = parser_.parse_rgb();
      two_colors = true;
    }
    for (;;) {
      if (parser_.accept(Keyword::fresnel)) {
        from_zero = finish_.reflection_fresnel = parser_.parse_optional_float(1) != 0;
      } else if (parser_.accept(Keyword::falloff)) {
        finish_.reflection_falloff = number();
      } else if (parser_.accept(Keyword::exponent)) {
        finish_.reflection_exponent = number();
      } else if (parser_.accept(Keyword::metallic)) {
        finish_.reflection_metallic = static_cast<float>(parser_.parse_optional_float(1));
      } else {
        break;
      }
    }
    if (!two_colors) {
      finish_.reflection_min = from_zero ? RGB(0.0f) : finish_.reflection_max;
    }
    parser_.expect_close("reflection");
  }

  // Items that now belong to interior{}.
  bool accept_legacy() {
    if (parser_.accept(Keyword::ior)) {
      finish_.legacy_ior = number();
    } else if (parser_.accept(Keyword::caustics)) {
      finish_.legacy_caustics = number();
    } else if (parser_.accept(Keyword::refraction)) {
      finish_.legacy_refraction = number();
    } else {
      return false;
    }
    parser_.warning("this item belongs into interior{} since version 3.1");
    return true;
  }

  // `albedo`: the share of light that the lobe sends back in all (8.3, 8.4). The word holds for its whole
  // block: also `phong albedo 0.2 phong 0.1` gives a share (measured on povray 3.7).
  void apply_albedo() {
    if (albedo_diffuse_) {
      finish_.diffuse *= (finish_.brilliance + 1) / 2;
      finish_.diffuse_back *= (finish_.brilliance + 1) / 2;
    }
    if (albedo_phong_) finish_.phong *= (finish_.phong_size + 1) / 2;
    if (albedo_specular_) {
      const float e = finish_.roughness != 0 ? 1 / finish_.roughness : 0;
      finish_.specular *= (e + 2) / (4 * (2 - std::pow(2.0f, -e / 2)));
    }
  }

  Parser& parser_;
  FinishNode& finish_;
  bool albedo_diffuse_ = false, albedo_phong_ = false, albedo_specular_ = false;
};

}  // namespace

std::shared_ptr<const FinishNode> parse_finish(Parser& parser,
                                               const std::shared_ptr<const FinishNode>& start) {
  parser.expect_open("finish");
  const auto named = parser.accept_identifier<FinishNode>(ValueKind::finish);
  auto finish = make_node<FinishNode>(named ? *named : *start);
  FinishReader(parser, *finish).read();
  parser.expect_close("finish");
  return finish;
}

}  // namespace durer
