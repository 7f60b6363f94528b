// A pattern as written: kind, parameters, warps (spec/textures.md 4-9).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "tracer/math/transform.h"
#include "tracer/scene/image_source.h"

namespace durer {

struct FunctionNode;
struct ObjectNode;
struct PigmentNode;

// Every pattern keyword of POV-Ray 3.7. bump_map and facets exist in normals only, image_map in
// pigments only.
enum class PatternKind : uint8_t {
  none, agate, aoi, average, boxed, bozo, brick, bump_map, bumps, cells, checker, crackle, cubic,
  cylindrical, density_file, dents, facets, function, gradient, granite, hexagon, image_map,
  image_pattern, julia, leopard, magnet_julia, magnet_mandel, mandel, marble, object, onion,
  pavement, pigment_pattern, planar, quilted, radial, ripples, slope, spherical, spiral1, spiral2,
  spotted, square, tiling, triangular, uv_mapping, waves, wood, wrinkles,
};

enum class WaveKind : uint8_t { ramp, sine, triangle, scallop, cubic, poly };

struct Turbulence {
  Vec3 strength{0};
  int octaves = 6;
  float omega = 0.5f;
  float lambda = 2.0f;
};

struct RepeatWarp {
  int axis = 0;
  float width = 1;
  Vec3 flip{0};
  Vec3 offset{0};
};

struct BlackHoleWarp {
  Vec3 center{0};
  Vec3 repeat{0};
  Vec3 uncertainty{0};  // `turbulence` inside black_hole
  double radius = 1;
  double strength = 1;
  double power = 2;  // `falloff`
  int type = 0;
  bool inverted = false;
  bool has_repeat = false;
  bool has_uncertainty = false;
};

struct PlanarWarp {
  Vec3 orientation{0, 0, 1};
  double distance = 0;
};
struct CylindricalWarp {
  Vec3 orientation{0, 0, 1};
  double distance_exponent = 0;
};
struct SphericalWarp {
  Vec3 orientation{0, 0, 1};
  double distance_exponent = 0;
};
struct ToroidalWarp {
  Vec3 orientation{0, 0, 1};
  double distance_exponent = 0;
  double major_radius = 1;
};
struct CubicWarp {};

// Transforms and warp{} items, in the order of the text; the chain is applied to a point from the
// last item to the first (inverse transforms), then the pattern's own turbulence.
using Warp = std::variant<Transform, Turbulence, RepeatWarp, BlackHoleWarp, PlanarWarp,
                          CylindricalWarp, SphericalWarp, ToroidalWarp, CubicWarp>;

// Appends a transform; adjacent ones merge into one matrix.
void append_transform(std::vector<Warp>& chain, const Transform& transform);

struct CrackleParameters {
  Vec3 form{-1, 1, 0};
  double metric = 2;
  double offset = 0;
  bool solid = false;
};

// julia, mandel, magnet (spec/textures.md 7).
struct FractalParameters {
  int magnet_type = 1;  // magnet 1, 2
  Vec2 coordinates{0, 0};  // julia's constant
  int iterations = 0;
  int exponent = 2;
  int exterior_type = 1;
  double exterior_factor = 1;
  int interior_type = 0;
  double interior_factor = 1;
};

struct BrickParameters {
  Vec3 size{8, 3, 4.5};
  double mortar = 0.5;
};

struct SlopeParameters {
  Vec3 direction{0};
  bool is_point = false;  // `slope { point_at ... }`
  double low_slope = 0, high_slope = 0;  // with has_slope_range
  Vec3 altitude{0};
  bool has_altitude = false;
  double low_altitude = 0, high_altitude = 0;
};

struct FacetsParameters {
  double coordinates_size = 0;  // `coords`
  double size = 0.1;            // `size`
  double metric = 2;
};

// pavement (spec/textures.md 9) and tiling (8).
struct PavementParameters {
  int sides = 3;
  int tiles = 1;
  int pattern = 1;
  int exterior = 0;
  int interior = 0;
  int form = 0;
};

struct PatternNode {
  PatternKind kind = PatternKind::none;
  WaveKind wave = WaveKind::ramp;
  float wave_exponent = 1;
  float frequency = 1;  // 0: the value is used as it is (spec/textures.md 4)
  float phase = 0;
  int noise_generator = 0;  // 0: that of the scene
  bool has_turbulence = false;  // the pattern's own slot exists
  Turbulence turbulence;
  std::vector<Warp> warps;

  // Parameters; which apply depends on the kind.
  float agate_turbulence = 1;
  Vec3 gradient{1, 0, 0};
  int arms = 0;  // spiral1, spiral2
  double quilt_control0 = 1, quilt_control1 = 1;
  int tiling_type = 0;
  BrickParameters brick;
  CrackleParameters crackle;
  FractalParameters fractal;
  SlopeParameters slope;
  FacetsParameters facets;
  PavementParameters pavement;
  int density_interpolation = 0;  // 0 none, 1 trilinear, 2 tricubic
  std::string density_file;  // path as found
  std::shared_ptr<const ImageSource> image;
  std::shared_ptr<const FunctionNode> function;
  std::shared_ptr<const ObjectNode> object;
  std::shared_ptr<const PigmentNode> pigment;
  SourcePosition position;
};

}  // namespace durer
