#include "tracer/texture/default_maps.h"

namespace durer {
namespace {

constexpr ColorRGBFT rgb(float r, float g, float b) { return {r, g, b, 0, 0}; }

constexpr ColorRGBFT kBlack = rgb(0, 0, 0), kWhite = rgb(1, 1, 1), kRed = rgb(1, 0, 0),
                     kGreen = rgb(0, 1, 0), kBlue = rgb(0, 0, 1), kYellow = rgb(1, 1, 0),
                     kCyan = rgb(0, 1, 1), kMagenta = rgb(1, 0, 1);

}  // namespace

const ColorMap& default_color_map(const PatternNode& pattern) {
  static const ColorMap two{{{0, kBlue}, {1, kGreen}}};
  static const ColorMap three{{{0, kBlue}, {1, kGreen}, {2, kRed}}};
  static const ColorMap brick{{{0, rgb(0.5f, 0.5f, 0.5f)}, {1, rgb(0.6f, 0.15f, 0.15f)}}};
  static const ColorMap four{{{0, kRed}, {1, kGreen}, {2, kBlue}, {3, kYellow}}};
  static const ColorMap six{
      {{0, kRed}, {1, kGreen}, {2, kBlue}, {3, kYellow}, {4, kCyan}, {5, kMagenta}}};
  static const ColorMap bozo{{{0.4f, kWhite},
                              {0.4f, kGreen},
                              {0.6f, kGreen},
                              {0.6f, kBlue},
                              {0.8f, kBlue},
                              {0.8f, kRed}}};
  static const ColorMap wood{
      {{0.6f, rgb(0.666f, 0.312f, 0.2f)}, {0.6f, rgb(0.4f, 0.1333f, 0.066f)}}};
  static const ColorMap mandel{{{0.001f, kBlack},
                                {0.001f, kCyan},
                                {0.012f, kYellow},
                                {0.015f, kMagenta},
                                {0.1f, kCyan}}};
  static const ColorMap agate{{{0, kWhite},
                               {0.5f, rgb(0.95f, 0.75f, 0.5f)},
                               {0.5f, rgb(0.9f, 0.7f, 0.5f)},
                               {0.6f, rgb(0.9f, 0.7f, 0.4f)},
                               {0.6f, rgb(1, 0.7f, 0.4f)},
                               {1, rgb(0.6f, 0.3f, 0)}}};
  static const ColorMap radial{{{0, kCyan}, {0.333f, kYellow}, {0.666f, kMagenta}, {1, kCyan}}};
  static const ColorMap marble{
      {{0, rgb(0.9f, 0.8f, 0.8f)}, {0.9f, rgb(0.9f, 0.08f, 0.08f)}, {0.9f, kBlack}}};
  static const ColorMap grey{{{0, kBlack}, {1, kWhite}}};
  switch (pattern.kind) {
    case PatternKind::checker:
    case PatternKind::object:
      return two;
    case PatternKind::hexagon:
      return three;
    case PatternKind::brick:
      return brick;
    case PatternKind::square:
      return four;
    case PatternKind::triangular:
    case PatternKind::cubic:
      return six;
    case PatternKind::bozo:
      return bozo;
    case PatternKind::wood:
      return wood;
    case PatternKind::mandel:
      return pattern.fractal.exponent == 2 ? mandel : grey;
    case PatternKind::agate:
      return agate;
    case PatternKind::radial:
      return radial;
    case PatternKind::marble:
      return marble;
    default:
      return grey;
  }
}

}  // namespace durer
