// The scene made ready for rays: immutable while they fly (design.md 1). Shading sees the world only
// through this header.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tracer/math/ray.h"
#include "tracer/scene/scene.h"
#include "tracer/shapes/shape_tests.h"
#include "tracer/texture/surface_texture.h"

namespace durer {

struct BvhBeam;
class CompiledShapes;

// Ray-kind flags that decide which objects a ray sees (spec/geometry.md 6.5).
struct RayClass {
  bool primary = false;    // straight from the camera
  bool reflected = false;  // has a reflection in its history, also after refractions
  bool shadow = false;
  bool photon = false;
  bool radiosity = false;
};

// The least that names a hit; normal and uv are found only after the search.
struct Hit {
  double t = 0;          // world distance
  uint32_t item = 0;     // where in the world's arrays; meaning private to the world
  uint32_t part = 0;     // side, triangle, component … of that item
  uint32_t instance = 0; // copy of a shared subtree; 0: none
  float barycentric_u = 0, barycentric_v = 0;
  uint32_t object = kNoObject;  // position at scene level
  static constexpr uint32_t kNoObject = 0xffffffffu;
};

// Shadow rays pass over what they meet up to this depth (spec/shading.md 10).
inline constexpr double kShadowTolerance = 1e-3;

// Where shadow rays begin.
struct ShadowStart {
  Vec3 point;
  Vec3 normal;      // of the surface, unit
  double distance;  // from where it is seen: how far apart the pixels beside it lie
  uint32_t object;  // that the surface belongs to, as Hit::object
};

inline constexpr uint32_t kNoTexture = 0xffffffffu;

// What indirect light needs to know of an object; most say nothing.
struct IndirectSettings {
  PhotonSettings photons;
  double radiosity_importance = -1;  // negative: not set
  bool operator==(const IndirectSettings&) const = default;
};

// What a surface is made of, by index. One per primitive and copy.
struct WorldObject {
  uint32_t texture = kNoTexture;           // index into World::textures()
  uint32_t interior_texture = kNoTexture;  // used where the ray leaves
  int interior = 0;                        // index into World::interiors()
  int light_group = -1;                    // innermost light group, -1: none
  uint32_t indirect = 0;                   // index into World::indirect_settings(); 0: none said
  bool uv_mapping : 1 = false;
  bool double_illuminate : 1 = false;
  bool no_shadow : 1 = false, no_image : 1 = false;
  bool no_reflection : 1 = false, no_radiosity : 1 = false;
  bool inverted : 1 = false;
  bool operator==(const WorldObject&) const = default;
};

// Every object has one (spec/shading.md 11.2); members of a CSG share their parent's.
struct WorldInterior {
  std::shared_ptr<const InteriorNode> node;  // null: the implicit one
  float ior = 1;                             // with "not set" resolved
  float dispersion = 1;
  int dispersion_samples = 7;
  double caustics = 0;   // exponent of the brightening of shadows; 0: none
  float refraction = 1;  // factor on the light that passes each surface
  bool hollow = false;
  bool operator==(const WorldInterior&) const = default;
};

// Interiors by number. Each object's is its own, told apart by the number alone: most are alike.
class InteriorTable {
 public:
  const WorldInterior& operator[](int number) const { return kinds_[kind_of_[number]]; }
  size_t size() const { return kind_of_.size(); }
  // All that occur among them, perhaps some twice.
  const std::vector<WorldInterior>& kinds() const { return kinds_; }

  int add(const WorldInterior& interior);
  // One more like this one.
  int add_copy(int number);
  void set(int number, const WorldInterior& interior) { kind_of_[number] = kind(interior); }

 private:
  uint32_t kind(const WorldInterior& interior);

  std::vector<uint32_t> kind_of_;
  std::vector<WorldInterior> kinds_;
};

struct TextureShare {
  uint32_t texture;  // index into World::textures()
  float weight;
};

// All about a hit that shading asks for.
struct SurfacePoint {
  static constexpr int kMostShares = 64;

  Vec3 point;         // world
  Vec3 normal;        // unit, raw orientation of the shape incl. its inverse mark (geometry.md 7)
  Vec2 uv{0};
  const WorldObject* object = nullptr;
  uint32_t scene_object = Hit::kNoObject;  // as Hit::object
  // The textures that share the surface, interior texture already chosen: one for most, several for
  // meshes with texture_list, blobs, cutaway_textures; none: black.
  int share_count = 0;
  TextureShare shares[kMostShares];

  // What share i and later ones in its texture weigh together, without those below `least`; 0 where
  // an earlier one has counted it.
  float joined_weight(int i, double least) const {
    const TextureShare& share = shares[i];
    if (share_count == 1) return share.weight;
    for (int j = 0; j < i; ++j) {
      if (shares[j].texture == share.texture) return 0;
    }
    float sum = 0;
    for (int j = i; j < share_count; ++j) {
      const bool counts = !(static_cast<double>(shares[j].weight) < least);
      if (counts && shares[j].texture == share.texture) sum += shares[j].weight;
    }
    return sum;
  }
};

// A light with its group; positions are final.
struct WorldLight {
  std::shared_ptr<const LightNode> node;  // transformed into the world
  int light_group = -1;                   // -1: a global light
};
struct LightGroup {
  bool global_lights = false;  // of an outermost group: its members are lit by the global lights
  int parent = -1;             // the group around this one, -1: none
};


struct WorldOptions {
  int bounding_threshold = 3;
  bool remove_bounds = true;
  bool split_unions = false;
};

class World {
 public:
  // Textures are compiled with the settings.
  static std::unique_ptr<World> build(const Scene& scene, const WorldOptions& options,
                                      const TextureSettings& textures = {});
  // The same of these objects instead of the scene's; each is let go on its way into the world.
  static std::unique_ptr<World> build(const Scene& scene, std::vector<ObjectPtr> objects,
                                      const WorldOptions& options,
                                      const TextureSettings& textures);
  ~World();

  // The nearest hit with 1e-4 <= t < max_t among what this kind of ray sees (geometry.md 2).
  // `beam`: of a bundle that this ray belongs to, or null; the hit is the same.
  bool closest_hit(const Vec3& origin, const Vec3& unit_direction, const RayClass& kind,
                   double max_t, Hit& hit, const BvhBeam* beam = nullptr) const;
  // Prepares for a bundle of rays, closest_hit() with this max_t. False: it is not worth it.
  bool make_beam(const Ray* rays, int count, double max_t, BvhBeam& beam) const;
  void surface_point(const Vec3& origin, const Vec3& unit_direction, const Hit& hit,
                     SurfacePoint& out) const;
  // True if an object whose textures are all opaque and which casts shadows lies at
  // kShadowTolerance < t < max_t; also at t >= 1e-4, where POV-Ray has it in mind (decision 0042).
  // Objects that let light through: closest_clear_hit.
  // `light`: a hint, rays towards one light are often stopped by one object.
  bool occluded_by_opaque(const ShadowStart& start, const Vec3& unit_direction, double max_t,
                          int light) const;
  // Whether any object that casts shadows is left out above.
  bool has_clear_casters() const;
  // The nearest hit, kShadowTolerance < t < max_t, of a shadow ray with the objects that are left out
  // above.
  bool closest_clear_hit(const Vec3& origin, const Vec3& unit_direction, double max_t,
                         Hit& hit) const;
  // Solids with clear parts that POV-Ray takes for what stopped the light last (decision 0069), and
  // the nearest hit, 1e-4 <= t < max_t, with any of them.
  bool has_remembered_casters() const;
  // Chooses them, once: `stops_light` says whether a surface lets no light through in a direction.
  void choose_remembered_casters(
      const std::function<bool(const SurfacePoint& surface, const Vec3& direction)>& stops_light);
  bool closest_hit_of_remembered(const Vec3& origin, const Vec3& unit_direction, double max_t,
                                 Hit& hit) const;
  // The nearest hit with one object of projected_objects().
  bool closest_hit_of_projected(int light, const Vec3& origin, const Vec3& unit_direction,
                                double& t) const;
  // Interiors of the top-level objects that contain a point, in the order of geometry.md 9.
  // Writes at most `capacity` indices and returns their count.
  int containing_interiors(const Vec3& point, int* interiors, int capacity) const;

  const std::vector<CompiledTexture>& textures() const;
  const InteriorTable& interiors() const;
  const std::vector<IndirectSettings>& indirect_settings() const;
  const std::vector<WorldLight>& lights() const;
  const std::vector<LightGroup>& light_groups() const;
  // Box of all bounded objects.
  Bounds bounds() const;

 private:
  World();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// What the calling thread tested since it asked last. Hints start anew, so that counts do not depend
// on what the thread did before.
ShapeTestCounts take_shape_tests();

// One object handle compiled for the language's questions (geometry.md 10); cached by the caller.
class ObjectQuery {
 public:
  static std::shared_ptr<const ObjectQuery> build(const ObjectPtr& object, int effective_version);
  // The same with shapes of earlier queries.
  static std::shared_ptr<const ObjectQuery> build(const ObjectPtr& object, int effective_version,
                                                  CompiledShapes& shapes);
  ~ObjectQuery();

  // trace(): nearest hit from origin along unit_direction; raw normal. False: none.
  bool trace(const Vec3& origin, const Vec3& unit_direction, Vec3& point, Vec3& normal) const;
  bool inside(const Vec3& point) const;
  // False for shapes without an inside (triangles, patches, open meshes).
  bool has_inside() const;
  // The box with POV-Ray's single-precision rounding.
  Bounds extents() const;

 private:
  ObjectQuery();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace durer
