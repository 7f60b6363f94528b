// What the text said: everything that rendering needs, as plain data.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tracer/scene/camera.h"
#include "tracer/scene/light.h"
#include "tracer/scene/media.h"

namespace durer {

struct FogNode {  // spec/shading.md 13.2
  int type = 1;   // 1 constant, 2 ground
  ColorRGBFT color;
  double distance = 0;
  double altitude = 0, offset = 0;
  Vec3 up{0, 1, 0};
  bool has_turbulence = false;
  Turbulence turbulence;
  double turbulence_depth = 0.5;
};

struct RainbowNode {  // spec/shading.md 13.3
  Vec3 direction{0}, up{0, 1, 0};
  double angle = 0, width = 0, jitter = 0, distance = 1e10;
  double falloff_angle = 180, arc_angle = 180;  // degrees, of the whole arc
  std::shared_ptr<const ColorMap> color_map;
};

struct SkySphereNode {  // spec/textures.md 16
  std::vector<std::shared_ptr<const PigmentNode>> pigments;  // later ones on top
  RGB emission{1.0f};
  Transform transform;
};

struct RadiositySettings {  // spec/gi.md B1
  bool enabled = false;
  SourcePosition position;
  double adc_bailout = 0.01;
  bool always_sample = false;
  double brightness = 1;
  int count = 35;
  int direction_pool = 1600;
  double error_bound = 1.8;
  double gray_threshold = 0;
  double low_error_factor = 0.5;
  double max_sample = -1;
  double maximum_reuse = 0.2, minimum_reuse = 0.015;
  int nearest_count = 5;
  int adaptive_nearest_count = 0;
  double pretrace_start = 0.08, pretrace_end = 0.04;
  int recursion_limit = 2;
  bool normal = false, media = false, subsurface = false;
};

struct PhotonGlobals {  // spec/gi.md A1.1
  bool enabled = false;
  SourcePosition position;
  double spacing = 1;
  int count = 0;
  int gather_min = 20, gather_max = 100;
  int media_max_steps = 0;
  double media_spacing_factor = 1;
  double jitter = 0.4, autostop = 0.5;
  double expand_increase = 0.2;
  int expand_min = 35;
  std::array<double, 4> radius{0, 0, 0, 0};
  std::optional<double> adc_bailout;
  std::optional<int> max_trace_level;
  std::string save_file, load_file;
};

enum class AssumedGamma : uint8_t { none, power, srgb };

struct GlobalSettings {
  double adc_bailout = 1.0 / 255.0;
  RGB ambient_light{1.0f};
  AssumedGamma gamma_kind = AssumedGamma::none;
  double assumed_gamma = 1.0;
  RGB irid_wavelength{0.70f, 0.52f, 0.48f};
  int max_trace_level = 5;
  double mm_per_unit = 10;
  int noise_generator = 2;
  bool noise_generator_given = false;
  int number_of_waves = 10;
  bool subsurface = false;
  SourcePosition subsurface_position;
  int subsurface_samples_diffuse = 50, subsurface_samples_single = 50;
  bool subsurface_radiosity = false;
  PhotonGlobals photons;
  RadiositySettings radiosity;
  std::optional<double> radiosity_default_importance;
};

struct Scene {
  std::vector<ObjectPtr> objects;  // top-level statements in order, light sources among them
  std::shared_ptr<const CameraNode> camera;  // the one that renders; never null after parsing
  std::vector<std::shared_ptr<const CameraNode>> cameras;  // all, for clockless animation
  ColorRGBFT background{0, 0, 0, 0, 1};
  std::vector<FogNode> fogs;
  std::vector<RainbowNode> rainbows;
  std::shared_ptr<const SkySphereNode> sky_sphere;
  std::vector<std::shared_ptr<const MediaNode>> atmosphere;
  GlobalSettings settings;
  TexturePtr default_texture;  // in force when parsing ended
  // Hundredths: language version at the end, and the effective one (spec/language.md 19).
  int language_version = 370;
  int effective_version = 362;
};

}  // namespace durer
