#include "tracer/shading/shading_scene.h"

#include "tracer/scene/not_supported.h"
#include "tracer/world/pattern_services.h"

namespace durer {
namespace {

// Volumes and indirect light that a picture of this quality would show but that are not there yet.
void refuse_missing_features(const Scene& scene, const World& world, int quality) {
  if (quality < 9) return;
  if (!scene.atmosphere.empty()) {
    throw NotSupported("media in the atmosphere", scene.atmosphere.front()->position);
  }
  for (const WorldInterior& interior : world.interiors()) {
    if (interior.node && !interior.node->media.empty() && interior.hollow) {
      throw NotSupported("media inside an object", interior.node->media.front()->position);
    }
  }
  if (scene.settings.radiosity.enabled) throw NotSupported("radiosity", {});
  if (scene.settings.photons.enabled) throw NotSupported("photons", {});
}

}  // namespace

TextureSettings texture_settings(const Scene& scene, const ShadingOptions& options) {
  return {{scene.settings.noise_generator, scene.settings.number_of_waves, nullptr},
          options.quality,
          scene.effective_version};
}

ShadingScene::ShadingScene(const Scene& from, std::unique_ptr<World> built,
                           const ShadingOptions& chosen)
    : scene(from),
      world(std::move(built)),
      options(chosen),
      new_opacity_rule(from.effective_version >= 370),
      atmosphere(from,
                 WorldPatternServices(texture_settings(from, chosen), from.settings).settings(),
                 chosen.output_alpha) {
  refuse_missing_features(scene, *world, options.quality);

  // Textures, and which of them can never let light through.
  const WorldPatternServices services(texture_settings(scene, options), scene.settings);
  const TextureSettings& settings = services.settings();
  std::vector<bool> opaque;
  for (const TexturePtr& node : world->textures()) {
    textures.push_back(compile_texture(*node, settings));
    opaque.push_back(textures.back()->is_opaque);
    for (const TextureLayer& layer : textures.back()->layers) {
      if (layer.finish.has_subsurface && scene.settings.subsurface && options.quality >= 9) {
        throw NotSupported("subsurface light transport", node->pattern.position);
      }
    }
  }
  world->set_opaque_textures(std::move(opaque));

  // Members of a group see their group's lights, and the global ones only if it says so.
  lights_by_group.resize(world->light_groups().size() + 1);
  for (size_t i = 0; i < world->lights().size(); ++i) {
    const WorldLight& light = world->lights()[i];
    lights.emplace_back(*light.node);
    if (light.light_group >= 0) continue;
    lights_by_group[0].push_back(static_cast<int>(i));
    for (size_t group = 0; group < world->light_groups().size(); ++group) {
      if (world->light_groups()[group].global_lights) {
        lights_by_group[group + 1].push_back(static_cast<int>(i));
      }
    }
  }
  for (size_t i = 0; i < world->lights().size(); ++i) {
    const int group = world->lights()[i].light_group;
    if (group >= 0) lights_by_group[group + 1].push_back(static_cast<int>(i));
  }
}

}  // namespace durer
