// Colour expressions (spec/language.md 6).
#include <algorithm>
#include <cmath>

#include "parser/parser_state.h"

namespace durer {
namespace {

// One sRGB component to the scene's working space, in single precision as POV-Ray does it.
float decode_srgb(float c, const GlobalSettings& settings) {
  if (settings.gamma_kind == AssumedGamma::srgb) return c;
  const float linear = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  if (settings.gamma_kind == AssumedGamma::none || std::abs(1 - 1 / settings.assumed_gamma) <= 0.01) {
    return linear;
  }
  return std::pow(std::max(linear, 0.0f), 1 / static_cast<float>(settings.assumed_gamma));
}

}  // namespace

bool Parser::State::starts_color() {
  const Token& token = peek();
  if (token.kind == TokenKind::identifier) {
    // In a #declare an identifier alone starts a number; elsewhere colour identifiers are colours.
    return false;
  }
  if (token.kind != TokenKind::keyword) return false;
  switch (token.keyword) {
    case Keyword::color:
    case Keyword::rgb: case Keyword::rgbf: case Keyword::rgbt: case Keyword::rgbft:
    case Keyword::srgb: case Keyword::srgbf: case Keyword::srgbt: case Keyword::srgbft:
    case Keyword::red: case Keyword::green: case Keyword::blue: case Keyword::filter:
    case Keyword::transmit: case Keyword::alpha:
      return true;
    default:
      return false;
  }
}

void Parser::State::parse_color(Terms& out, bool full) {
  for (double& c : out.v) c = 0;
  out.count = 5;
  accept(Keyword::color);
  bool first = true;
  for (;; first = false) {
    peek();
    if (look.token.kind == TokenKind::keyword) {
      const Keyword keyword = look.token.keyword;
      int component = -1, width = 0;
      bool transmit_fourth = false, srgb = false;
      switch (keyword) {
        case Keyword::red: component = 0; break;
        case Keyword::green: component = 1; break;
        case Keyword::blue: component = 2; break;
        case Keyword::alpha:
          message(Severity::warning, "the word 'alpha' is no longer used, 'filter' replaces it");
          component = 3;
          break;
        case Keyword::filter: component = 3; break;
        case Keyword::transmit: component = 4; break;
        case Keyword::srgb: srgb = true; width = 3; break;
        case Keyword::rgb: width = 3; break;
        case Keyword::srgbf: srgb = true; width = 4; break;
        case Keyword::rgbf: width = 4; break;
        case Keyword::srgbt: srgb = true; width = 4; transmit_fourth = true; break;
        case Keyword::rgbt: width = 4; transmit_fourth = true; break;
        case Keyword::srgbft: srgb = true; width = 5; break;
        case Keyword::rgbft: width = 5; break;
        default: break;
      }
      if (component >= 0) {
        consume();
        out.v[component] = static_cast<float>(parse_float());
        continue;
      }
      if (width > 0) {
        if (!first) break;
        consume();
        if (srgb && !gamma_known) {
          error("srgb colours need assumed_gamma to be set before them, in global_settings");
        }
        Terms terms;
        parse_express(terms, 1);
        const int given = terms.count;
        if (given > width) {
          message(Severity::warning, "there are more components after '" +
                                         std::string(spelling(keyword)) + "' than it has");
        }
        terms.promote(width);
        for (int i = terms.count; i < 5; ++i) terms.v[i] = 0;
        if (transmit_fourth && given < 5) {
          terms.v[4] = terms.v[3];
          terms.v[3] = 0;
        } else if (transmit_fourth) {
          terms.v[4] = terms.v[3];
          terms.v[3] = 0;
        }
        for (int i = 0; i < 3 && srgb; ++i) {
          terms.v[i] = decode_srgb(static_cast<float>(terms.v[i]), scene.settings);
        }
        for (int i = 0; i < 5; ++i) out.v[i] = static_cast<float>(terms.v[i]);
        continue;
      }
      if (keyword == Keyword::t) break;
    }
    if (!first || !starts_expression()) break;
    Terms terms;
    const int width = full ? 5 : 3;
    parse_express(terms, 1);
    if (full && terms.count != 5) {
      terms.promote(5);
    }
    terms.promote(width);
    for (int i = 0; i < 5; ++i) out.v[i] = i < terms.count ? static_cast<float>(terms.v[i]) : 0.0f;
  }
}

}  // namespace durer
