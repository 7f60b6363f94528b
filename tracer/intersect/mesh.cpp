#include "tracer/intersect/mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>

#include "tracer/intersect/box_walk.h"
#include "tracer/intersect/bvh.h"
#include "tracer/intersect/bvh_walk.h"
#include "tracer/intersect/embree_mesh.h"
#include "tracer/shapes/triangle.h"

namespace durer {
namespace {

// From this many triangles on Embree's hierarchy pays for its start.
constexpr size_t kEmbreeThreshold = 3000;
constexpr double kLeastDepth = 1e-6;  // in normalised local space
constexpr float kSameNormal = 1e-10f;

class Mesh final : public Shape {
 public:
  explicit Mesh(std::shared_ptr<const ShapeNode> node)
      : node_(std::move(node)), mesh_(std::get<Rare<MeshNode>>(*node_)) {
    const size_t count = mesh_.face_vertices.size();
    for (const auto& face : mesh_.face_vertices) bounds_.extend(box_of(face));
    if (count < kEmbreeThreshold) {
      bvh_.build(count, bounds_, [&](uint32_t face) { return box_of(mesh_.face_vertices[face]); });
    } else {
      embree_ = std::make_unique<EmbreeMesh>(mesh_.vertices, mesh_.face_vertices, bounds_);
    }
    if (mesh_.face_planes.empty()) add_planes();
    if (mesh_.inside_vector) inside_direction_ = normalize_or_zero(*mesh_.inside_vector);
    is_solid_ = inside_direction_ != Vec3(0);
    has_holes_ = is_solid_ && leaves_edges_open();
    all_textured_ = !mesh_.textures.empty() && mesh_.face_textures.size() == count &&
                    std::all_of(mesh_.face_textures.begin(), mesh_.face_textures.end(),
                                [](const auto& t) { return t[0] >= 0; });
  }

  Bounds bounds() const override { return bounds_; }

  void hits(const ShapeRay& ray, HitStack& out) const override {
    const LocalRay local(ray);
    if (ray.csg_child && !is_solid_ && !ray.is_clipped) {
      hits_of_patches(local, out);
      return;
    }
    const size_t first = out.size();
    for_each_candidate(local, kGreatestDepth, [&](uint32_t face, bool is_sure, double&) {
      const double depth = depth_of(local, face, is_sure);
      if (depth >= 0) out.push(depth / local.length, face);
    });
    if (!embree_) put_ties_in_order(local, first, out);
  }

  bool closest(const ShapeRay& ray, HitStack&, ShapeHit& hit) const override {
    const LocalRay local(ray);
    const double least = std::max(kLeastDepth, kLeastHitDepth * local.length);
    double best = std::min(ray.t_max * local.length, kGreatestDepth * (1 + 1e-15));
    bool found = false;
    const auto consider = [&](uint32_t face, double depth) {
      if (depth < least || depth > best) return;
      if (depth == best && (!found || !is_found_later(local, face, hit.part))) return;
      best = depth;
      hit.part = face;
      found = true;
    };
    if (embree_) {
      uint32_t face;
      // Embree's nearest triangle, unless it turns out to be too near to count.
      if (!embree_->nearest(ray.origin, local.direction, least, best, face)) return false;
      const double depth = plane_depth(local, face);
      if (depth >= least && depth < best) {
        best = depth;
        hit.part = face;
        found = true;
      }
    }
    if (!found) {
      for_each_candidate(local, best, [&](uint32_t face, bool is_sure, double& limit) {
        const double depth = depth_of(local, face, is_sure);
        if (depth >= 0) consider(face, depth);
        limit = best;
      });
    }
    if (!found) return false;
    hit.t = best / local.length;
    return hit.t < ray.t_max && hit.t >= kLeastHitDepth;
  }

  bool inside(const Vec3& point) const override {
    return is_solid_ && inside_along(point, inside_direction_);
  }
  // Through a hole a ray from outside may meet one side only.
  bool is_solid_within_bounds() const override { return !has_holes_; }
  // inside_vector stays as it is where the mesh is turned: meshes with holes show it.
  bool looks_along_world() const override { return is_solid_; }
  bool inside_moved(const Vec3& point, const Transform& placement, bool inverted) const override {
    const Vec3 direction = placement.inverse_direction(inside_direction_);
    return inside_along(point, direction) != inverted;
  }

  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override {
    if (!is_smooth(hit.part)) return Vec3(plane(hit.part).normal);
    const MeshAltitude& of = (altitudes_.empty() ? mesh_.face_altitudes : altitudes_)[hit.part];
    const auto& n = mesh_.face_normals[hit.part];
    const Corners c = corners(hit.part);
    const int first = of.is_exchanged, second = 1 - first;
    const Vec3 at_first(mesh_.normals[n[first]]), at_second(mesh_.normals[n[second]]),
        at_third(mesh_.normals[n[2]]);
    double u, v;
    smooth_weights(c.p[first], c.p[second], c.p[2], Vec3(of.altitude), p, u, v);
    if (u < 1e-10) return at_first;
    return at_first + u * (at_second - at_first + v * (at_third - at_second));
  }
  bool has_unit_normals() const override { return mesh_.face_normals.empty(); }
  bool has_unit_normal(const ShapeHit& hit) const override { return !is_smooth(hit.part); }

  Vec2 uv(const Vec3& p, const Vec3&, const ShapeHit& hit) const override {
    if (hit.part >= mesh_.face_uv.size()) {
      return mesh_.uv.size() == 1 ? mesh_.uv[0] : Vec2(0);
    }
    const auto& index = mesh_.face_uv[hit.part];
    if (index[0] < 0) return Vec2(0);
    double w[3];
    barycentric(corners(hit.part), p, w);
    return w[0] * mesh_.uv[index[0]] + w[1] * mesh_.uv[index[1]] + w[2] * mesh_.uv[index[2]];
  }

  bool is_patch() const override { return !is_solid_; }
  bool ends_at_nearest_hit() const override { return true; }
  // Without inside_vector `inverse` turns the normals over and nothing else (measured on povray 3.7).
  bool takes_inverse_mark() const override { return true; }
  bool inside_inverted(const Vec3& point) const override { return is_solid_ && !inside(point); }

  const std::vector<TexturePtr>* own_textures() const override {
    return mesh_.textures.empty() ? nullptr : &mesh_.textures;
  }
  int texture_shares(const Vec3& p, const ShapeHit& hit, ShapeTexture* shares,
                     int) const override {
    if (hit.part >= mesh_.face_textures.size()) {
      shares[0] = {-1, 1.0f};
      return 1;
    }
    const auto& t = mesh_.face_textures[hit.part];
    // One texture; three are mixed even if they are the same, since small shares are left out.
    if (t[0] < 0 || t[1] < 0 || t[2] < 0) {
      shares[0] = {t[0], 1.0f};
      return 1;
    }
    double w[3];
    barycentric(corners(hit.part), p, w);
    double sum = 0;
    for (double& weight : w) {
      weight = std::clamp(weight, 0.0, 1.0);
      sum += weight;
    }
    for (int i = 0; i < 3; ++i) shares[i] = {t[i], static_cast<float>(w[i] / sum)};
    return 3;
  }
  bool needs_object_texture() const override { return !all_textured_; }

 private:
  // Three normals that are not all the same.
  bool is_smooth(uint32_t face) const {
    if (face >= mesh_.face_normals.size()) return false;
    const auto& n = mesh_.face_normals[face];
    return n[0] >= 0 && n[1] >= 0 && n[2] >= 0 &&
           !(same(mesh_.normals[n[0]], mesh_.normals[n[1]]) &&
             same(mesh_.normals[n[0]], mesh_.normals[n[2]]));
  }
  // Whether some edge belongs to an odd number of faces. In the sum of all edges' hashes those that
  // two faces share cancel out; places count, not numbers, since vertices may be listed twice.
  bool leaves_edges_open() const {
    const auto mixed = [](uint64_t z) {  // splitmix64's finaliser (Steele, Lea, Flood 2014)
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
      return z ^ (z >> 31);
    };
    const auto hash_of = [&](int32_t vertex) {
      uint64_t hash = 0;
      for (int i = 0; i < 3; ++i) {
        const float place = mesh_.vertices[vertex][i] + 0.0f;  // -0 is 0
        hash = mixed(hash + 0x9e3779b97f4a7c15ull + std::bit_cast<uint32_t>(place));
      }
      return hash;
    };
    uint64_t sum = 0;
    for (const auto& face : mesh_.face_vertices) {
      const uint64_t corner[3] = {hash_of(face[0]), hash_of(face[1]), hash_of(face[2])};
      for (int i = 0; i < 3; ++i) sum ^= mixed(corner[i] + corner[(i + 1) % 3]);
    }
    return sum != 0;
  }

  // Whether a ray meets an odd number of triangles.
  bool inside_along(const Vec3& point, const Vec3& direction) const {
    const LocalRay local(ShapeRay{point, direction, false, true, kHugeDepth});
    int count = 0;
    for_each_candidate(local, kGreatestDepth, [&](uint32_t face, bool is_sure, double&) {
      count += depth_of(local, face, is_sure) >= 0;
    });
    return count % 2 != 0;
  }

  struct LocalRay {
    explicit LocalRay(const ShapeRay& ray) : origin(ray.origin) {
      length = ray.unit_direction ? 1 : durer::length(ray.direction);
      direction = ray.direction * (1 / length);
    }
    Vec3 origin, direction;
    double length;
  };
  struct Corners {
    Vec3 p[3];
  };

  Corners corners(uint32_t face) const {
    const auto& v = mesh_.face_vertices[face];
    return {{Vec3(mesh_.vertices[v[0]]), Vec3(mesh_.vertices[v[1]]), Vec3(mesh_.vertices[v[2]])}};
  }
  Bounds box_of(const std::array<int32_t, 3>& face) const {
    glm::vec3 low = mesh_.vertices[face[0]], high = low;
    for (int i = 1; i < 3; ++i) {
      low = glm::min(low, mesh_.vertices[face[i]]);
      high = glm::max(high, mesh_.vertices[face[i]]);
    }
    return {Vec3(low), Vec3(high)};
  }
  void add_planes() {
    const size_t count = mesh_.face_vertices.size();
    planes_.reserve(count);
    if (!mesh_.face_normals.empty()) altitudes_.reserve(count);
    for (uint32_t face = 0; face < count; ++face) {
      const Corners c = corners(face);
      planes_.push_back(mesh_plane_of(c.p[0], c.p[1], c.p[2]));
      if (!mesh_.face_normals.empty()) {
        altitudes_.push_back(mesh_altitude_of(c.p[0], c.p[1], c.p[2]));
      }
    }
  }
  const MeshPlane& plane(uint32_t face) const {
    return mesh_.face_planes.empty() ? planes_[face] : mesh_.face_planes[face];
  }
  static bool same(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = a - b;
    return dot(d, d) <= kSameNormal;
  }
  static void barycentric(const Corners& c, const Vec3& p, double* w) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 &own = c.p[i], &a = c.p[(i + 1) % 3], &b = c.p[(i + 2) % 3];
      // From the opposite side to this corner, perpendicular to that side.
      const Vec3 side = normalize_or_zero(b - a);
      const Vec3 up = (own - a) - dot(own - a, side) * side;
      w[i] = 1 + dot(p - own, up) / dot(up, up);
    }
  }

  double plane_depth(const LocalRay& ray, uint32_t face) const {
    const MeshPlane& of = plane(face);
    const Vec3 n(of.normal);
    return -(dot(n, ray.origin) - static_cast<double>(of.distance)) / dot(n, ray.direction);
  }

  // Depth in normalised local space, negative for none. `is_sure`: the triangle is known to be met,
  // only its depth is asked (shared edges must not leak).
  double depth_of(const LocalRay& ray, uint32_t face, bool is_sure) const {
    const MeshPlane& of = plane(face);
    const Vec3 n(of.normal);
    const double slope = dot(n, ray.direction);
    if (std::abs(slope) < kGeometryEpsilon) return -1;
    const double depth = -(dot(n, ray.origin) - static_cast<double>(of.distance)) / slope;
    if (!(depth >= kLeastDepth && depth <= kGreatestDepth)) return -1;
    if (is_sure) return depth;
    const Corners c = corners(face);
    int a, b;
    projection_axes(n, a, b);
    const bool exchange = needs_exchange(c.p[0], c.p[1], c.p[2], a, b);
    const double s = ray.origin[a] + depth * ray.direction[a];
    const double t = ray.origin[b] + depth * ray.direction[b];
    return covers(c.p[exchange ? 1 : 0], c.p[exchange ? 0 : 1], c.p[2], a, b, s, t) ? depth : -1;
  }

  const BoxHierarchy& hierarchy() const {
    std::call_once(hierarchy_made_, [&] {
      std::vector<FloatBox> boxes;
      for (const auto& face : mesh_.face_vertices) boxes.push_back(FloatBox::from(box_of(face)));
      hierarchy_ = std::make_unique<BoxHierarchy>(boxes);
    });
    return *hierarchy_;
  }

  // Of two triangles met at one depth the one that is found later counts.
  bool is_found_later(const LocalRay& local, uint32_t face, uint32_t other) const {
    thread_local BoxWalk walk;
    walk.start(hierarchy(), local.origin, local.direction);
    while (!walk.is_over()) {
      double key;
      const int64_t element = walk.next(key).element;
      if (element == face) return false;
      if (element == other) return true;
    }
    return face > other;
  }

  // Of hits of one depth the last one pushed counts.
  void put_ties_in_order(const LocalRay& local, size_t first, HitStack& out) const {
    if (out.size() - first < 2) return;
    // Equal ones side by side: a ray may meet every triangle.
    thread_local std::vector<size_t> places;
    places.clear();
    for (size_t i = first; i < out.size(); ++i) places.push_back(i);
    std::sort(places.begin(), places.end(), [&](size_t i, size_t j) {
      return out[i].t != out[j].t ? out[i].t < out[j].t : i < j;
    });
    for (size_t i = 0; i < places.size(); ++i) {
      ShapeHit& one = out[places[i]];
      for (size_t j = i + 1; j < places.size() && out[places[j]].t == one.t; ++j) {
        ShapeHit& other = out[places[j]];
        if (is_found_later(local, one.part, other.part)) std::swap(one.part, other.part);
      }
    }
  }

  // Without inside_vector the walk ends where the next box starts behind the hit found last: what
  // lies behind it is not there for CSG.
  void hits_of_patches(const LocalRay& local, HitStack& out) const {
    thread_local BoxWalk walk;
    walk.start(hierarchy(), local.origin, local.direction);
    double last = kGreatestDepth;
    while (!walk.is_over()) {
      double key;
      const BoxHierarchy::Node& node = walk.next(key);
      if (key > last) break;
      if (node.element < 0) continue;
      const uint32_t face = static_cast<uint32_t>(node.element);
      const double depth = depth_of(local, face, false);
      if (depth < 0) continue;
      last = depth;
      out.push(depth / local.length, face);
    }
  }

  // visit(face, is_sure, limit) for triangles that the ray may meet before max_depth.
  template <typename Visit>
  void for_each_candidate(const LocalRay& ray, double max_depth, Visit&& visit) const {
    if (embree_) {
      struct Context {
        Visit& visit;
        double limit;
      } context{visit, max_depth};
      embree_->visit_all(
          ray.origin, ray.direction, max_depth,
          [](void* data, uint32_t face) {
            auto& c = *static_cast<Context*>(data);
            c.visit(face, true, c.limit);
          },
          &context);
      return;
    }
    const std::vector<uint32_t>& faces = bvh_.items();
    bvh_.visit_ray({ray.origin, ray.direction}, max_depth,
                   [&](uint32_t first, uint32_t count, double& limit) {
                     for (uint32_t i = first; i < first + count; ++i) visit(faces[i], false, limit);
                     return false;
                   });
  }

  std::shared_ptr<const ShapeNode> node_;
  const MeshNode& mesh_;
  std::vector<MeshPlane> planes_;        // where the node has none
  std::vector<MeshAltitude> altitudes_;  // likewise, of meshes with smooth faces
  Bvh bvh_;
  std::unique_ptr<EmbreeMesh> embree_;
  // POV-Ray's, made when a CSG first asks for all hits, or where triangles coincide: most members
  // of unions are never asked.
  mutable std::once_flag hierarchy_made_;
  mutable std::unique_ptr<const BoxHierarchy> hierarchy_;
  Bounds bounds_;
  Vec3 inside_direction_{0};
  bool is_solid_ = false;
  bool has_holes_ = false;
  bool all_textured_ = false;
};

}  // namespace

std::shared_ptr<const Shape> compile_mesh(const std::shared_ptr<const ShapeNode>& node) {
  return std::make_shared<Mesh>(node);
}

}  // namespace durer
