#include "tracer/world/remembered_casters.h"

#include <cmath>
#include <numbers>

#include "tracer/world/shadow_casters.h"

namespace durer {
namespace {

// Among more solids than that, the one remembered is seldom the one that a ray meets (decision 0069).
constexpr size_t kMostRemembered = 6;

GeometryRay own_ray(const WorldData& data, const RememberedCaster& caster, const GeometryRay& ray) {
  return caster.instance < 0 ? ray : local_ray(data.instances[caster.instance], ray);
}

Vec3 lattice_point(int i, const Vec3& step) {
  const Vec3 p = static_cast<double>(i) * step;
  return p - glm::floor(p);
}

class Finder {
 public:
  explicit Finder(const WorldData& data) : data_(data) {}

  std::vector<RememberedCaster> candidates() {
    for (const TopLevelObject& top : data_.scene.objects) {
      if (top.hidden & kShadowRay) continue;
      if (top.instance < 0) {
        add(top.node, -1);
        continue;
      }
      const ObjectSet& inner = data_.groups[data_.instances[top.instance].group]->set;
      for (const TopLevelObject& member : inner.objects) {
        if (!(member.hidden & kShadowRay) && member.instance < 0) add(member.node, top.instance);
      }
    }
    return std::move(found_);
  }

  // Whether something that stops light lies open, so that it is what a shadow ray from the ground
  // or from the solid itself meets first. Looked for from all directions, through points that fill
  // its box.
  bool shows_what_stops_light(const RememberedCaster& caster, const StopsLight& stops_light) {
    const GeometryNode& node = data_.geometry.nodes[caster.node];
    if (!node.surface_is_bounded || !node.reach.is_bounded()) {
      return has_opaque_member(caster.node);
    }
    const Bounds box = caster.instance < 0
                           ? node.reach
                           : data_.instances[caster.instance].transform.bounds(node.reach);
    const double diagonal = length(box.size());
    constexpr int kRays = 256;
    for (int i = 1; i <= kRays; ++i) {
      // Lattices of low discrepancy in three and in two dimensions.
      const Vec3 place = lattice_point(i, Vec3(0.8191725134, 0.6710436067, 0.5497004779));
      const Vec3 aim = lattice_point(i, Vec3(0.7548776662, 0.5698402910, 0));
      const double z = 2 * aim.x - 1, radius = std::sqrt(1 - z * z),
                   angle = 2 * std::numbers::pi * aim.y;
      const Vec3 direction(radius * std::cos(angle), radius * std::sin(angle), z);
      const Vec3 point = box.min + place * box.size();
      const GeometryRay ray(point - diagonal * direction, direction, kShadowRay);
      ShapeHit hit;
      if (data_.geometry.closest(caster.node, own_ray(data_, caster, ray), 2 * diagonal, stack_,
                                 hit) &&
          stops_light(caster, ray, hit)) {
        return true;
      }
    }
    return false;
  }

 private:
  bool has_opaque_member(uint32_t index) const {
    const GeometryNode& node = data_.geometry.nodes[index];
    if (node.kind == NodeKind::shape) return is_opaque_node(data_, index);
    for (uint32_t i = 0; i < node.children.count; ++i) {
      if (has_opaque_member(data_.geometry.lists[node.children.first + i])) return true;
    }
    return false;
  }

  // Solids, whole or in unions, whose own plain textures stop light, of members some of which do
  // not.
  void add(uint32_t index, int32_t instance) {
    const GeometryNode& node = data_.geometry.nodes[index];
    if (node.kind == NodeKind::union_) {
      if (node.clips.count) return;
      for (uint32_t i = 0; i < node.children.count; ++i) {
        add(data_.geometry.lists[node.children.first + i], instance);
      }
      return;
    }
    if (node.kind != NodeKind::merge && node.kind != NodeKind::intersection) return;
    const auto stops_light = [&](uint32_t texture) {
      return data_.textures[texture].is_opaque && !data_.textures[texture].selector;
    };
    const WorldObject& object = data_.objects[node.object];
    if (object.texture == kNoTexture || !stops_light(object.texture)) return;
    if (object.interior_texture != kNoTexture && !stops_light(object.interior_texture)) return;
    if (!is_opaque_node(data_, index)) found_.push_back({index, instance});
  }

  const WorldData& data_;
  std::vector<RememberedCaster> found_;
  HitStack stack_;
};

}  // namespace

std::vector<RememberedCaster> find_remembered_casters(const WorldData& data,
                                                      const StopsLight& stops_light) {
  Finder finder(data);
  std::vector<RememberedCaster> casters = finder.candidates();
  if (casters.size() > kMostRemembered) return {};
  std::erase_if(casters, [&](const RememberedCaster& caster) {
    return !finder.shows_what_stops_light(caster, stops_light);
  });
  return casters;
}

const RememberedCaster* closest_of_remembered(const WorldData& data,
                                              const std::vector<RememberedCaster>& casters,
                                              const GeometryRay& ray, double max_t, HitStack& stack,
                                              ShapeHit& hit) {
  const RememberedCaster* nearest = nullptr;
  for (const RememberedCaster& caster : casters) {
    const GeometryRay own = own_ray(data, caster, ray);
    const GeometryNode& node = data.geometry.nodes[caster.node];
    ShapeHit candidate;
    if (node.bounds.count && !data.geometry.passes_bounds(node, own, stack)) continue;
    if (!data.geometry.closest(caster.node, own, max_t, stack, candidate)) continue;
    max_t = candidate.t;
    hit = candidate;
    nearest = &caster;
  }
  return nearest;
}

}  // namespace durer
