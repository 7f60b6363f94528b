// A colour at every point: how patterns and functions see a pigment without knowing pigments.
#pragma once

#include "tracer/math/vector.h"
#include "tracer/scene/color.h"

namespace durer {

struct PatternContext;

class ColorField {
 public:
  virtual ~ColorField() = default;

  // The colour at p; context may be null (no surface: slope and aoi are 0). False: "no colour",
  // outside an image with `once` (spec/textures.md 11); color is then rgbft <1,1,1,0,1>.
  virtual bool color(const Vec3& p, const PatternContext* context, ColorRGBFT& color) const = 0;
};

}  // namespace durer
