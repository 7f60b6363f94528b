// Colours of spectral bands (spec/shading.md 11.6).
#pragma once

#include "tracer/scene/color.h"

namespace durer {

// Mean hue of a band; over all bands of a split 380..730 nm the hues average to nearly white.
// `bands`: into how many the range was split.
RGB band_hue(double wavelength, double width, int bands);

}  // namespace durer
