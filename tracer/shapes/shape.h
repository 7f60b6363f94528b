// The interface of every shape: immutable, in its own space, without texture or flags
// (design.md rule 2). How to add one: a file with `compile(const XNode&, …)`, and its declaration in
// registry.cpp.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/scene/shapes.h"
#include "tracer/shapes/shape_ray.h"
#include "tracer/shapes/shape_tests.h"

namespace durer {

struct ShapeHit {
  double t;       // world distance
  uint32_t node;  // who was hit; filled in by HitStack
  uint32_t part;  // side, segment, triangle …: the shape's own business
  float u, v;     // likewise
  // One number of full precision in place of u and v.
  double parameter() const { return std::bit_cast<double>(std::array<float, 2>{u, v}); }
};

// Where shapes push their hits. One per thread, reused: it does not allocate once it has grown.
class HitStack {
 public:
  HitStack() : hits_(256) {}
  void push(double t, uint32_t part = 0, float u = 0, float v = 0) { push({t, owner, part, u, v}); }
  void push_with_parameter(double t, uint32_t part, double parameter) {
    const auto [u, v] = std::bit_cast<std::array<float, 2>>(parameter);
    push(t, part, u, v);
  }
  void push(const ShapeHit& hit) {
    if (size_ == hits_.size()) [[unlikely]] hits_.resize(2 * size_);
    hits_[size_++] = hit;
  }
  size_t size() const { return size_; }
  void shrink(size_t size) { size_ = size; }
  ShapeHit& operator[](size_t i) { return hits_[i]; }
  const ShapeHit& operator[](size_t i) const { return hits_[i]; }

  uint32_t owner = 0;  // the node whose shape pushes at present
  ShapeTestCounts shape_tests{};  // of this thread
  // What stopped the last shadow ray towards each of some lights is likely to stop the next one:
  // positions in the list of opaque casters, kNoOccluder where nothing did.
  static constexpr uint32_t kNoOccluder = 0xffffffffu;
  std::array<uint32_t, 16> last_occluder = no_occluders();

  static std::array<uint32_t, 16> no_occluders() {
    std::array<uint32_t, 16> none;
    none.fill(kNoOccluder);
    return none;
  }

  void count_test(uint8_t shape_kind, bool hit) {
    ++shape_tests[shape_kind].by_outcome[hit];
  }

 private:
  std::vector<ShapeHit> hits_;  // room for them
  size_t size_ = 0;
};

// Where a line meets a convex solid or a half space.
struct LineHits {
  int count = 0;
  double t[4];  // world distance
  uint32_t part[4];

  void add(double depth, uint32_t which = 0) {
    t[count] = depth;
    part[count++] = which;
  }
  void push_to(HitStack& stack) const {
    for (int i = 0; i < count; ++i) stack.push(t[i], part[i]);
  }
};

// A share of a surface in one of Shape::own_textures(); -1: in the object's texture.
struct ShapeTexture {
  int index;
  float weight;
};

class Shape {
 public:
  virtual ~Shape() = default;

  // Encloses the surface; kUnboundedExtent where there is no bound. Reported by min_extent(), so
  // with the margins of the specification and no others.
  virtual Bounds bounds() const = 0;
  // Pushes every hit within the shape's own depth limits (spec/geometry.md 16.1), in the order of
  // the specification: of equal depths the last one wins.
  virtual void hits(const ShapeRay& ray, HitStack& out) const = 0;
  // Solid test, without any inverse mark. Patches: always false.
  virtual bool inside(const Vec3& point) const = 0;
  // Whether the test looks from the point along a direction that stays the world's where the shape is
  // moved; then inside_moved() is asked, with or without the mark.
  virtual bool looks_along_world() const { return false; }
  virtual bool inside_moved(const Vec3& point, const Transform&, bool inverted) const {
    return inverted ? inside_inverted(point) : inside(point);
  }
  // Whether all points outside bounds() are outside the solid, too.
  virtual bool is_solid_within_bounds() const { return true; }
  // The same test of the inverted solid; differs from the negation where borders are in neither.
  virtual bool inside_inverted(const Vec3& point) const { return !inside(point); }
  // Whether povray finds the point of a hit in the shape's own space, which last digits show: then
  // place() gives it there.
  virtual bool places_hits() const { return false; }
  virtual Vec3 place(const ShapeRay& ray, const ShapeHit& hit) const;
  // Local, of any length but zero.
  virtual Vec3 normal(const Vec3& point, const ShapeHit& hit) const = 0;
  // They are of length 1 but for rounding; povray leaves them so where there is no transform.
  virtual bool has_unit_normals() const { return false; }
  virtual bool has_unit_normal(const ShapeHit&) const { return has_unit_normals(); }
  virtual Vec2 uv(const Vec3& point, const Vec3& world_point, const ShapeHit& hit) const;

  // Of shapes that can be swept: what hits() pushes, in its order; more than two where the part of this
  // line within the solid may not be told from them.
  virtual void line_hits(const ShapeRay&, LineHits&) const {}

  // The hit of least depth t with kLeastHitDepth <= t < ray.t_max.
  virtual bool closest(const ShapeRay& ray, HitStack& scratch, ShapeHit& hit) const;

  // The same shape moved, if it takes this transform into itself; otherwise null: then the
  // transform is kept beside the shape.
  virtual std::shared_ptr<const Shape> transformed(const Transform& transform) const;
  // What it is with a transform beside it; null: the same.
  virtual std::shared_ptr<const Shape> beside_transform() const { return nullptr; }
  // The same shape for `inverse`, if it takes it into itself (plane, quadric).
  virtual std::shared_ptr<const Shape> inverted() const;

  // Convex, and the surface is closed: a line meets it where it enters and where it leaves the
  // inside, and nowhere else.
  virtual bool is_convex_solid() const { return false; }
  // All points on one side of a plane.
  virtual bool is_half_space() const { return false; }
  // Whether lines lie within it on one interval or, if it is_outside_of_convex(), outside of it; then
  // line_hits() finds the ends. `is_marked`: it has been inverted.
  virtual bool can_be_swept(bool /*is_marked*/) const {
    return is_convex_solid() || is_half_space();
  }
  virtual bool is_outside_of_convex() const { return false; }
  // Looking for hits costs no more than a test of bounds().
  virtual bool is_quickly_missed() const { return false; }
  // No inside, not invertible (spec/geometry.md 13).
  virtual bool is_patch() const { return false; }
  // Whether what lies behind its nearest hit is not there for who asks for all hits, but for CSG.
  virtual bool ends_at_nearest_hit() const { return false; }
  // clipped_by only installs its box (spec/geometry.md 13.6).
  virtual bool ignores_clips() const { return false; }
  // `inverse` marks the object (spec/geometry.md 4.3).
  virtual bool takes_inverse_mark() const { return !is_patch(); }
  // Seen outside its box where there is no hierarchy (spec/geometry.md 2.2).
  virtual bool is_exempt_from_box_test() const { return false; }
  // Textures of components (blob, mesh), and their shares at a hit; at most `capacity`.
  virtual const std::vector<TexturePtr>* own_textures() const { return nullptr; }
  virtual int texture_shares(const Vec3& point, const ShapeHit& hit, ShapeTexture* shares,
                             int capacity) const;
  // Blobs keep their component textures on the inside, too.
  virtual bool ignores_interior_texture() const { return false; }
  // False when every part has its own texture, so the object needs none.
  virtual bool needs_object_texture() const { return true; }
};

// A shape with the transform that its statement implies (axis frames).
struct PlacedShape {
  std::shared_ptr<const Shape> shape;
  bool has_transform = false;
  Rare<Transform> transform;
};

struct ShapeContext {
  int effective_version = 370;
};

// Null shape: never hit (degenerate), or no shape of its own (CSG, lights, text; meshes: compile_mesh()).
PlacedShape compile_shape(const ShapeNode& node, const ShapeContext& context);

}  // namespace durer
