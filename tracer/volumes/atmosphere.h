// What a ray meets where it meets nothing, and what lies over long distances: background, sky
// sphere, fog, rainbow (spec/shading.md 13).
#pragma once

#include <memory>
#include <vector>

#include "tracer/scene/scene.h"
#include "tracer/texture/surface_texture.h"

namespace durer {

class Atmosphere {
 public:
  Atmosphere(const Scene& scene, const TextureSettings& settings, bool output_alpha);

  // Light from beyond all objects. `alpha_background`: the background may be transparent (not for
  // reflected rays).
  void background(const Vec3& direction, bool alpha_background, RGB& color, float& transmit) const;
  // Fog over a segment; for shadow rays it only attenuates.
  void apply_fog(const Vec3& origin, const Vec3& direction, double depth, bool shadow, RGB& color,
                 float& transmit) const;
  // Rainbows over a segment. `jitter` is a uniform number in [0,1).
  void apply_rainbow(const Vec3& direction, double depth, double jitter, RGB& color,
                     float& transmit) const;
  bool has_fog() const { return !fogs_.empty(); }
  bool has_rainbow() const { return !rainbows_.empty(); }

 private:
  struct Rainbow {
    RainbowNode node;
    Vec3 direction, up;
    double start_angle, width, arc, falloff;  // radians
  };

  void old_background(const Vec3& direction, RGB& color, float& transmit) const;

  bool new_rules_;
  bool output_alpha_;
  int noise_generator_;
  ColorRGBFT background_;
  std::vector<std::shared_ptr<const CompiledPigment>> sky_pigments_;
  Transform sky_transform_;
  RGB sky_emission_{1.0f};
  std::vector<FogNode> fogs_;
  std::vector<Rainbow> rainbows_;
};

}  // namespace durer
