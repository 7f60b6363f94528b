#include "tracer/shading/shading_scene.h"

#include "tracer/scene/not_supported.h"
#include "tracer/shading/direct_light.h"
#include "tracer/world/pattern_services.h"

namespace durer {
namespace {

// Volumes and indirect light that a picture of this quality would show but that are not there yet.
void refuse_missing_features(const Scene& scene, int quality) {
  if (quality < 9) return;
  if (!scene.atmosphere.empty()) {
    throw NotSupported("media in the atmosphere", scene.atmosphere.front()->position);
  }
  const RadiositySettings& radiosity = scene.settings.radiosity;
  if (radiosity.enabled) throw NotSupported("radiosity", radiosity.position);
  const PhotonGlobals& photons = scene.settings.photons;
  if (photons.enabled) throw NotSupported("photons", photons.position);
}

void refuse_missing_features(const Scene& scene, const World& world, int quality) {
  if (quality < 9) return;
  for (const WorldInterior& interior : world.interiors().kinds()) {
    if (interior.node && !interior.node->media.empty() && interior.hollow) {
      throw NotSupported("media inside an object", interior.node->media.front()->position);
    }
  }
  if (!scene.settings.subsurface) return;
  for (const CompiledTexture& texture : world.textures()) {
    for (const TextureLayer& layer : texture.layers) {
      if (layer.finish->has_subsurface) {
        throw NotSupported("subsurface light transport", scene.settings.subsurface_position);
      }
    }
  }
}

std::unique_ptr<World> build_world(const Scene& scene, std::vector<ObjectPtr> objects,
                                   const WorldOptions& world, const ShadingOptions& options) {
  refuse_missing_features(scene, options.quality);
  const WorldPatternServices services(texture_settings(scene, options), scene.settings);
  return World::build(scene, std::move(objects), world, services.settings());
}

std::vector<int> lights_of_group(const World& world, int group) {
  std::vector<int> result;
  for (size_t i = 0; i < world.lights().size(); ++i) {
    if (world.lights()[i].light_group == group) result.push_back(static_cast<int>(i));
  }
  return result;
}

// The lights that shine on the members of a group: the global ones if the outermost group around
// them has global_lights, and those of the innermost group that has any.
std::vector<int> lights_on(const World& world, int group) {
  std::vector<int> global = lights_of_group(world, -1), local;
  for (; group >= 0; group = world.light_groups()[group].parent) {
    const LightGroup& around = world.light_groups()[group];
    if (local.empty()) local = lights_of_group(world, group);
    if (around.parent < 0 && !around.global_lights) global.clear();
  }
  global.insert(global.end(), local.begin(), local.end());
  return global;
}

}  // namespace

TextureSettings texture_settings(const Scene& scene, const ShadingOptions& options) {
  return {{scene.settings.noise_generator, scene.settings.number_of_waves, nullptr},
          options.quality,
          scene.effective_version};
}

ShadingScene::ShadingScene(const Scene& from, std::vector<ObjectPtr> objects,
                           const WorldOptions& world_options, const ShadingOptions& chosen)
    : scene(from),
      options(chosen),
      world(build_world(from, std::move(objects), world_options, chosen)),
      new_opacity_rule(from.effective_version >= 370),
      textures(world->textures()),
      atmosphere(from,
                 WorldPatternServices(texture_settings(from, chosen), from.settings).settings(),
                 chosen.output_alpha) {
  refuse_missing_features(scene, *world, options.quality);
  for (const WorldLight& light : world->lights()) lights.emplace_back(*light.node);
  const int groups = static_cast<int>(world->light_groups().size());
  for (int group = -1; group < groups; ++group) lights_by_group.push_back(lights_on(*world, group));
  world->choose_remembered_casters([&](const SurfacePoint& surface, const Vec3& direction) {
    return stops_light(*this, surface, direction);
  });
}

}  // namespace durer
