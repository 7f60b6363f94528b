// The world with everything that shading looks up by index: compiled textures, lights, interiors.
#pragma once

#include <memory>
#include <vector>

#include "tracer/lights/light.h"
#include "tracer/shading/interior_list.h"
#include "tracer/texture/surface_texture.h"
#include "tracer/volumes/atmosphere.h"
#include "tracer/world/world.h"

namespace durer {

struct ShadingOptions {
  int quality = 9;            // 0..9 (spec/shading.md 15)
  bool output_alpha = false;  // +UA: the background is transparent
  int bits = 8;               // per channel of the picture: what can be seen in it
};

// What textures of a scene are compiled with.
TextureSettings texture_settings(const Scene& scene, const ShadingOptions& options);

struct ShadingScene {
  // Throws NotSupported for what something visible needs and shading cannot do yet.
  // The objects are let go on their way into the world.
  ShadingScene(const Scene& scene, std::vector<ObjectPtr> objects, const WorldOptions& world,
               const ShadingOptions& options);

  const Scene& scene;
  ShadingOptions options;
  std::unique_ptr<World> world;
  bool new_opacity_rule;  // effective version >= 3.7 (spec/shading.md 16)
  const std::vector<CompiledTexture>& textures;                  // by world index
  std::vector<Light> lights;                                     // by world index
  // Which lights shine on the members of a group: lists of light indices; entry 0: outside groups.
  std::vector<std::vector<int>> lights_by_group;
  Atmosphere atmosphere;

  // Whether a ray in these interiors meets the air's fog, media and rainbows: all are hollow.
  bool is_in_air(const InteriorList& interiors) const {
    for (const int i : interiors) {
      if (!world->interiors()[i].hollow) return false;
    }
    return true;
  }
  const std::vector<int>& lights_of(const WorldObject& object) const {
    return lights_by_group[object.light_group + 1];
  }
};

}  // namespace durer
