// light_source{} as written (spec/shading.md 9).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "tracer/scene/object.h"

namespace durer {

enum class LightKind : uint8_t { point, spot, cylinder };  // fill = point with shadowless

struct LightPhotons {
  std::optional<bool> refraction, reflection;
  bool area_light = false;
};

struct LightNode {
  Vec3 location{0};
  RGB color{0.0f};
  LightKind kind = LightKind::point;
  Vec3 point_at{0, 0, 1};
  bool parallel = false;
  bool shadowless = false;
  // Degrees as written (spot) or plain radii (cylinder).
  double radius = 30, falloff = 45, tightness = 0;
  bool radius_given = false, falloff_given = false, tightness_given = false;
  // area_light axis1, axis2, size1, size2
  bool area = false;
  Vec3 axis1{0}, axis2{0};
  int size1 = 1, size2 = 1;
  int adaptive = 100;
  bool jitter = false, circular = false, orient = false, area_illumination = false;
  double fade_distance = 0, fade_power = 0;
  bool media_interaction = true, media_attenuation = false;
  ObjectPtr looks_like;
  ObjectPtr projected_through;
  LightPhotons photons;
  SourcePosition position;
};

}  // namespace durer
