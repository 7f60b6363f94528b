// What a ray carries from surface to surface (design.md 1).
#pragma once

#include <cstdint>
#include <string>

#include "tracer/math/vector.h"
#include "tracer/shading/interior_list.h"
#include "tracer/world/world.h"

namespace durer {

// 380..730 nm split into bands by dispersion; width 0: the ray carries all wavelengths.
struct SpectralBand {
  double wavelength = 0;  // centre, nm
  double width = 0;       // nm

  bool is_monochromatic() const { return width > 0; }
};

// Why a ray flies; RayClass beside it decides what it sees.
enum class RayKind : uint8_t { primary, reflected, refracted, shadow, photon, cache };

// What happened on a path so far, in Heckbert's notation: E at the eye, S at mirrors and glass, D where
// a surface scatters, L at a light. Keeps the first 32 events.
class PathEvents {
 public:
  enum class Event : uint8_t { eye, specular, diffuse, light };

  PathEvents() { append(Event::eye); }
  void append(Event event) {
    if (count_ < kMost) events_ |= static_cast<uint64_t>(event) << (2 * count_++);
  }
  std::string text() const {
    std::string letters;
    for (int i = 0; i < count_; ++i) letters += "ESDL"[events_ >> (2 * i) & 3];
    return letters;
  }

 private:
  static constexpr int kMost = 32;

  uint64_t events_ = 0;
  int count_ = 0;
};

// The depth of a ray that hits nothing.
inline constexpr double kFarAway = 2e10;

struct TracedRay {
  Vec3 origin;
  Vec3 direction;  // unit
  double max_depth = kFarAway;  // nothing behind is seen; only primary rays may be shortened
  RayClass kind;
  RayKind spawned_as = RayKind::primary;
  int level = 0;
  float weight = 1;
  // A hash of the ray's history: pixel, sub-sample and each bounce. Random draws that POV-Ray takes
  // from a thread's stream are functions of it (design.md rule 4a).
  uint64_t path = 0;
  const BvhBeam* beam = nullptr;  // of primary rays that fly in a bundle, else null
  PathEvents events;
  SpectralBand band;
  InteriorList interiors;
};

// One more event on a path: spawns `event`-th child of a ray.
inline uint64_t extend_path(uint64_t path, uint64_t event) {
  // splitmix64's finaliser (Steele, Lea, Flood 2014) over the pair.
  uint64_t z = path * 0x9e3779b97f4a7c15ull + event + 0x632be59bd9b4e019ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

// The counter-th 64 random bits that `purpose` draws on this path.
inline uint64_t path_random_bits(uint64_t path, uint32_t purpose, uint32_t counter) {
  return extend_path(path, (uint64_t{purpose} << 32) | counter);
}
// The same as a uniform number in [0,1).
inline double path_random(uint64_t path, uint32_t purpose, uint32_t counter) {
  return static_cast<double>(path_random_bits(path, purpose, counter) >> 11) * 0x1.0p-53;
}

}  // namespace durer
