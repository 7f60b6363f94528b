// What patterns ask of objects and pigments (tracer/patterns/pattern.h).
#pragma once

#include "tracer/image/image.h"
#include "tracer/patterns/pattern.h"
#include "tracer/texture/surface_texture.h"

namespace durer {

// Needed only while textures are compiled.
class WorldPatternServices final : public PatternServices {
 public:
  // `settings` without services; those that patterns below are compiled with.
  WorldPatternServices(TextureSettings settings, const GlobalSettings& globals)
      : images_({settings.effective_version, globals.gamma_kind, globals.assumed_gamma}),
        settings_(settings) {
    settings_.patterns.services = this;
    settings_.patterns.images = &images_;
  }
  WorldPatternServices(const WorldPatternServices&) = delete;
  WorldPatternServices& operator=(const WorldPatternServices&) = delete;

  const TextureSettings& settings() const { return settings_; }

  std::shared_ptr<const InsideTest> inside_test(
      const std::shared_ptr<const ObjectNode>& object) const override;
  std::shared_ptr<const GreyField> grey_field(
      const std::shared_ptr<const PigmentNode>& pigment) const override;

 private:
  ImageCache images_;  // what has been read
  TextureSettings settings_;
};

}  // namespace durer
