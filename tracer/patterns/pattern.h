// Patterns compiled for evaluation: warps, base value, frequency and wave form
// (spec/textures.md 4, 5).
#pragma once

#include <memory>
#include <vector>

#include "tracer/field/scalar_field.h"
#include "tracer/scene/pattern.h"

namespace durer {

// What a pattern may ask of the surface besides the point (slope, aoi, uv_mapping).
struct PatternContext {
  Vec3 normal{0, 0, 1};         // unit, facing the ray
  Vec3 ray_direction{0, 0, 1};  // unit
  Vec3 world_point{0};
  Vec2 uv{0};
  bool has_surface = false;  // false for functions, sky_sphere, media: slope and aoi give 0
};

// Interfaces to rooms that patterns must not know.
class InsideTest {  // pattern `object`
 public:
  virtual ~InsideTest() = default;
  virtual bool inside(const Vec3& p) const = 0;
};
class GreyField {  // pigment_pattern
 public:
  virtual ~GreyField() = default;
  virtual double grey(const Vec3& p, const PatternContext& context) const = 0;
};
class PatternServices {
 public:
  virtual ~PatternServices() = default;
  virtual std::shared_ptr<const InsideTest> inside_test(
      const std::shared_ptr<const ObjectNode>& object) const = 0;
  virtual std::shared_ptr<const GreyField> grey_field(
      const std::shared_ptr<const PigmentNode>& pigment) const = 0;
};

class ImageCache;

struct PatternSettings {
  int noise_generator = 2;  // the scene's; a pattern's own goes first
  int number_of_waves = 10;
  ImageCache* images = nullptr;               // needed by image_pattern
  const PatternServices* services = nullptr;  // needed by `object` and pigment_pattern
};

// Which noise a pattern uses.
inline int noise_generator_of(const PatternNode& node, const PatternSettings& settings) {
  return node.noise_generator ? node.noise_generator : settings.noise_generator;
}

// The value of a pattern before frequency, phase and wave form, at a warped point.
class BasePattern {
 public:
  virtual ~BasePattern() = default;
  virtual double base_value(const Vec3& p, const PatternContext& context) const = 0;
  // The same at four points near each other, for patterns that work them out together.
  virtual void base_values(const Vec3 points[4], const PatternContext& context,
                           double out[4]) const {
    for (int i = 0; i < 4; ++i) out[i] = base_value(points[i], context);
  }
  // Bounds of base_value over a box; infinite where nothing is known.
  virtual ValueRange base_range(const Bounds& box) const;
};

// Each pattern's file defines its factory; pattern_registry.cpp lists them. Null where the kind
// has no value of its own (image_map, bump_map, average, uv_mapping, none).
using PatternFactory = std::unique_ptr<const BasePattern> (*)(const PatternNode& node,
                                                             const PatternSettings& settings);
PatternFactory find_pattern_factory(PatternKind kind);
const char* pattern_name(PatternKind kind);

class Pattern : public ScalarField {
 public:
  Pattern(const PatternNode& node, const PatternSettings& settings);
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;

  // The point that the pattern (and children of its map) sees.
  Vec3 warp_point(const Vec3& p) const;
  // The finished value at an already warped point.
  double value_at_warped(const Vec3& warped, const PatternContext& context) const;
  void values_at_warped(const Vec3 warped[4], const PatternContext& context, double out[4]) const;
  double value(const Vec3& p, const PatternContext& context) const {
    return value_at_warped(warp_point(p), context);
  }
  double value(const Vec3& p) const override { return value(p, PatternContext{}); }
  void values(const Vec3 points[8], double out[8]) const override;
  ValueRange range(const Bounds& box) const override;

 private:
  double finished(double base_value) const;
  void apply_waves(double& value) const;
  Bounds warped_bounds(Bounds box) const;
  ValueRange range_of_waves(ValueRange range) const;

  PatternNode node_;
  const Transform* only_warp_;  // null: there is none, or not this one alone
  bool displaces_;              // the turbulence slot moves the point
  std::unique_ptr<const BasePattern> base_;
};

// The chain of spec/textures.md 5 applied to a point, `warps` in the order of the text; the
// pattern's own turbulence slot is not part of it. For image_map, uv-mapped children and the like.
Vec3 apply_warps(const std::vector<Warp>& warps, Vec3 p);
// Further out than this nothing is meant (spec/textures.md 5).
[[gnu::always_inline]] inline Vec3 kept_near(const Vec3& warped) {
  return glm::clamp(warped, Vec3(-1e17), Vec3(1e17));
}

}  // namespace durer
