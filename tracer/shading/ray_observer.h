// Whoever wants to know how a picture comes about: explanations, light-path expressions, statistics
// (design.md 1). A renderer without an observer pays one test of a pointer per ray.
#pragma once

#include <string>

#include "tracer/scene/color.h"
#include "tracer/shading/ray_state.h"

namespace durer {

struct RayResult;

enum class ContributionKind : uint8_t {
  ambient,       // `ambient` of a finish, or indirect light in its place
  emission,      // the surface shines
  direct,        // one light source
  photons,       // a photon map
  reflection,    // the result of a reflected ray
  transmission,  // the result of a ray that went on
  background     // nothing was hit
};

// A part of the light that comes back along a ray.
struct Contribution {
  ContributionKind kind;
  int light;  // index into ShadingScene::lights, -1: none
  // As it adds to the ray's result: after the layers above, before the weights of blended textures
  // and what lies in the air.
  RGB color;
};

// Called by every thread. For one ray: spawned, perhaps hit, contributions with the rays between
// that they needed, finished; so the rays between `spawned` and `finished` on one thread are its
// offspring.
class RayObserver {
 public:
  virtual ~RayObserver() = default;
  virtual void ray_spawned(const TracedRay&) {}
  virtual void ray_hit(const TracedRay&, const SurfacePoint&, double /*depth*/) {}
  // A light was looked for from a point: what of its colour gets there.
  virtual void light_tested(const TracedRay&, int /*light*/, const Vec3& /*point*/,
                            const RGB& /*arriving*/) {}
  virtual void contribution(const TracedRay&, const Contribution&) {}
  virtual void ray_finished(const TracedRay&, const RayResult&) {}
};

// The events of a contribution's whole path, from the eye to the light: "EDL", "ESSDL", "EL".
// Reflections and transmissions are parts of longer paths, and so is indirect light: their text
// ends where the ray does.
inline std::string path_text(const TracedRay& ray, ContributionKind kind) {
  switch (kind) {
    case ContributionKind::direct:
      return ray.events.text() + "DL";
    case ContributionKind::emission:
    case ContributionKind::background:
      return ray.events.text() + "L";
    case ContributionKind::ambient:
    case ContributionKind::photons:
      return ray.events.text() + "D";
    default:
      return ray.events.text();
  }
}

}  // namespace durer
