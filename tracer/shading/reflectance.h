// The scalar laws of POV-Ray's finish: highlights, Fresnel-like tints, reflectivity
// (spec/shading.md 8).
#pragma once

#include <algorithm>
#include <cmath>

#include "tracer/math/vector.h"
#include "tracer/scene/scene.h"

namespace durer {

// Mirror direction of d at a unit normal.
inline Vec3 mirrored(const Vec3& d, const Vec3& normal) { return d - (2 * dot(d, normal)) * normal; }

// Schlick-like grazing curve of `metallic`; x is the angle to the normal over a right angle.
inline float metallic_tint_share(double x) {
  const double value = 0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903;
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

// Highlights and reflections take the pigment's colour as `metallic` grows.
inline RGB metallic_tint(float metallic, double cosine, const RGB& pigment) {
  const double x = std::acos(std::clamp(cosine, -1.0, 1.0)) / (M_PI / 2);
  const float share = metallic * (1 - metallic_tint_share(x));
  return RGB(1.0f) + (pigment - RGB(1.0f)) * share;
}

struct Reflectivity {
  RGB color{0.0f};
  float weight = 0;  // factor on the reflected ray's weight
};

// 8.6; `cosine` = -d·N, `relative_ior` for Fresnel = new/old.
Reflectivity reflectivity(const FinishNode& finish, double cosine, double relative_ior,
                          const RGB& pigment);

// Factor of thin-film interference (8.5).
RGB irid_factor(const Irid& irid, const Vec3& point, double cosine_sum, const GlobalSettings& settings);

}  // namespace durer
