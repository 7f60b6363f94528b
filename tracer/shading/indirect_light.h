// Light that does not come straight from a light source: what room gi plugs into shading
// (design.md 1, spec/shading.md 18). Every answer here is the null one: there is none.
#pragma once

#include "tracer/scene/color.h"
#include "tracer/shading/ray_state.h"

namespace durer {

// Is handed the photons around a point, one after the other.
class PhotonVisitor {
 public:
  virtual ~PhotonVisitor() = default;
  // `towards_source`: unit, where the photon came from. `radiance`: irradiance/pi of this photon.
  virtual void photon(const Vec3& towards_source, const RGB& radiance) = 0;
};

// Thread-safe; one for the whole picture.
class IndirectLight {
 public:
  virtual ~IndirectLight() = default;

  // Irradiance/pi of a surface facing `normal`, by all light that other surfaces send (a radiosity
  // cache). `geometric_normal`: unbent, facing the ray. False: no such light; ambient is used.
  virtual bool ambient(const TracedRay& /*ray*/, const SurfacePoint& /*surface*/,
                       const Vec3& /*geometric_normal*/, const Vec3& /*normal*/, float /*weight*/,
                       RGB& /*radiance*/) const {
    return false;
  }
  // The photons that tell the light at a surface.
  virtual void gather_photons(const SurfacePoint& /*surface*/, PhotonVisitor& /*visitor*/) const {}
  // Light of photons that a medium scatters at a point into the ray, for a medium that scatters
  // everything.
  virtual RGB media_light(const TracedRay& /*ray*/, const Vec3& /*point*/) const {
    return RGB(0.0f);
  }
};

}  // namespace durer
