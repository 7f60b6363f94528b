#include "tracer/world/world.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracer/scene/not_supported.h"
#include "tracer/world/object_search.h"
#include "tracer/world/remembered_casters.h"
#include "tracer/world/shadow_casters.h"
#include "tracer/world/world_builder.h"

namespace durer {
namespace {

uint8_t kind_bits(const RayClass& kind) {
  int bits = kind.reflected * kReflectionRay | kind.shadow * kShadowRay | kind.photon * kPhotonRay |
             kind.radiosity * kRadiosityRay;
  bits |= (bits == 0) * kImageRay;
  return static_cast<uint8_t>(bits | kind.primary * kPrimaryRay);
}

// One per thread; grows to what the scene needs and stays.
HitStack& scratch() {
  thread_local HitStack stack;
  return stack;
}

Hit as_hit(const ShapeHit& from, uint32_t instance) {
  Hit hit;
  hit.t = from.t;
  hit.item = from.node;
  hit.part = from.part;
  hit.instance = instance;
  hit.barycentric_u = from.u;
  hit.barycentric_v = from.v;
  return hit;
}

Vec3 placed_hit(const WorldData& data, const GeometryNode& node, const Instance* instance,
                const Vec3& origin, const Vec3& unit_direction, const ShapeHit& hit) {
  const GeometryRay ray(origin, unit_direction, 0);
  if (!instance) return data.geometry.hit_point(node, ray, hit);
  return instance->transform.point(data.geometry.hit_point(node, local_ray(*instance, ray), hit));
}

bool found(const ClosestSearch& search, Hit& hit) {
  if (search.top < 0) return false;
  hit = as_hit(search.hit(), search.instance);
  hit.object = static_cast<uint32_t>(search.top);
  return true;
}

}  // namespace

struct World::Impl {
  WorldData data;

  void add_shares(uint32_t node, const Vec3& point, SurfacePoint& out) const;
  int containing(const ObjectSet& set, const Vec3& point, int64_t moved_from, int64_t moved_to,
                 int* interiors, int capacity) const;
};

ShapeTestCounts take_shape_tests() {
  scratch().last_occluder = HitStack::no_occluders();
  return std::exchange(scratch().shape_tests, {});
}

World::World() : impl_(std::make_unique<Impl>()) {}
World::~World() = default;

std::unique_ptr<World> World::build(const Scene& scene, const WorldOptions& options,
                                    const TextureSettings& textures) {
  return build(scene, scene.objects, options, textures);
}

std::unique_ptr<World> World::build(const Scene& scene, std::vector<ObjectPtr> objects,
                                    const WorldOptions& options, const TextureSettings& textures) {
  std::unique_ptr<World> world(new World);
  WorldData& data = world->impl_->data;
  WorldBuilder builder(data, options, scene.default_texture, textures);
  CompiledShapes shapes;
  ObjectResolver resolver(shapes, scene.effective_version);
  resolver.find_shared(objects);
  builder.expect(objects.size());
  for (ObjectPtr& object : objects) {
    ResolvedObject resolved = resolver.resolve(object);
    object.reset();
    builder.add_top_level(std::move(resolved));
  }
  builder.resolve_projected(resolver);
  builder.finish();
  for (const auto& group : data.groups) sort_shadow_casters(data, group->set);
  sort_shadow_casters(data, data.scene);
  return world;
}

bool World::closest_hit(const Vec3& origin, const Vec3& unit_direction, const RayClass& kind,
                        double max_t, Hit& hit, const BvhBeam* beam) const {
  const WorldData& data = impl_->data;
  GeometryRay ray(origin, unit_direction, kind_bits(kind));
  const ObjectSet& set = data.scene;
  ClosestSearch search(data, set, set.all, ray, scratch(), max_t);
  search.run(beam);
  return found(search, hit);
}

bool World::make_beam(const Ray* rays, int count, double max_t, BvhBeam& beam) const {
  const SearchList& list = impl_->data.scene.all;
  return !list.is_scanned && list.bvh.make_beam(rays, count, max_t, beam);
}

bool World::has_clear_casters() const {
  return !impl_->data.scene.clear_casters().is_empty();
}

bool World::closest_clear_hit(const Vec3& origin, const Vec3& unit_direction, double max_t,
                              Hit& hit) const {
  const WorldData& data = impl_->data;
  const ObjectSet& set = data.scene;
  GeometryRay ray(origin, unit_direction, kShadowRay);
  ClosestSearch search(data, set, set.clear_casters(), ray, scratch(), max_t);
  search.least = kShadowTolerance;
  search.run();
  return found(search, hit);
}

void World::surface_point(const Vec3& origin, const Vec3& unit_direction, const Hit& hit,
                          SurfacePoint& out) const {
  const WorldData& data = impl_->data;
  const GeometryNode& node = data.geometry.nodes[hit.item];
  const NodeAppearance& appearance = data.appearance[hit.item];
  const ShapeHit shape_hit{hit.t, hit.item, hit.part, hit.barycentric_u, hit.barycentric_v};
  out.object = &data.objects[node.object];
  out.scene_object = hit.object;
  const Instance* instance = hit.instance ? &data.instances[hit.instance - 1] : nullptr;
  Vec3 local = origin + hit.t * unit_direction;
  if (node.places_hits) [[unlikely]] {
    local = placed_hit(data, node, instance, origin, unit_direction, shape_hit);
  }
  out.point = local;
  if (instance) {
    const SharedGroup& group = *data.groups[instance->group];
    out.object = &data.objects[instance->first_object + node.object - group.first_object];
  }

  // Normal and uv in the shape's space.
  if (instance) local = instance->transform.inverse_point(local);
  if (node.transform >= 0) {
    const Transform& transform = data.geometry.transforms[node.transform];
    local = transform.inverse_point(local);
    out.normal = transform.normal(node.shape->normal(local, shape_hit));
  } else {
    out.normal = node.shape->normal(local, shape_hit);
  }
  if (instance) out.normal = instance->transform.normal(out.normal);
  const bool stays = !instance && node.transform < 0 &&
                     (appearance.has_unit_normals || node.shape->has_unit_normal(shape_hit));
  if (!stays) out.normal = unit_or_zero(out.normal);
  if (node.inverted) out.normal = -out.normal;
  out.uv = appearance.needs_uv ? node.shape->uv(local, out.point, shape_hit) : Vec2(0);

  // Textures (geometry.md 7).
  out.share_count = 0;
  const WorldObject& object = *out.object;
  const bool inside_out = dot(out.normal, unit_direction) > 0;
  if (appearance.own_textures >= 0) {
    const bool blends_itself = node.shape->ignores_interior_texture();
    if (inside_out && object.interior_texture != kNoTexture && !blends_itself) {
      out.shares[out.share_count++] = {object.interior_texture, 1.0f};
      return;
    }
    ShapeTexture shares[SurfacePoint::kMostShares];
    const int count =
        node.shape->texture_shares(local, shape_hit, shares, SurfacePoint::kMostShares);
    for (int i = 0; i < count; ++i) {
      uint32_t id = object.texture;
      if (shares[i].index >= 0) {
        id = data.own_texture_ids[appearance.own_textures + shares[i].index];
        if (id == kNoTexture) id = object.texture;
      }
      if (id != kNoTexture) out.shares[out.share_count++] = {id, shares[i].weight};
    }
    return;
  }
  if (inside_out && object.interior_texture != kNoTexture) {
    out.shares[out.share_count++] = {object.interior_texture, 1.0f};
  } else if (object.texture != kNoTexture) {
    out.shares[out.share_count++] = {object.texture, 1.0f};
  } else if (appearance.cutaway_root >= 0) {
    impl_->add_shares(static_cast<uint32_t>(appearance.cutaway_root), out.point, out);
  }
}

// The textures that a CSG's members lend to a cut (geometry.md 6.4).
void World::Impl::add_shares(uint32_t index, const Vec3& point, SurfacePoint& out) const {
  const GeometryNode& csg = data.geometry.nodes[index];
  const auto add = [&](uint32_t child) {
    if (out.share_count == SurfacePoint::kMostShares) return;
    const GeometryNode& member = data.geometry.nodes[child];
    if (!data.geometry.inside_unclipped(child, point)) return;
    if (member.kind != NodeKind::shape) {
      add_shares(child, point, out);
    } else if (data.objects[member.object].texture != kNoTexture) {
      out.shares[out.share_count++] = {data.objects[member.object].texture, 1.0f};
    }
  };
  const uint32_t* child = data.geometry.lists.data() + csg.children.first;
  const int before = out.share_count;
  if (csg.written_as_difference) {
    if (csg.children.count) add(child[0]);
    return;
  }
  for (uint32_t i = 0; i < csg.children.count; ++i) add(child[i]);
  const int added = out.share_count - before;
  for (int i = before; i < out.share_count; ++i) {
    out.shares[i].weight = 1.0f / static_cast<float>(std::max(added, 1));
  }
}

bool World::occluded_by_opaque(const ShadowStart& start, const Vec3& unit_direction, double max_t,
                               int light) const {
  const WorldData& data = impl_->data;
  GeometryRay ray(start.point, unit_direction, kShadowRay);
  ray.t_max = max_t;
  HitStack& stack = scratch();
  uint32_t& last = stack.last_occluder[static_cast<size_t>(light) % stack.last_occluder.size()];
  return OcclusionSearch{data, data.scene, ray, stack, &start}.run_with_hint(last);
}

bool World::has_remembered_casters() const {
  return !impl_->data.remembered.empty();
}

void World::choose_remembered_casters(
    const std::function<bool(const SurfacePoint& surface, const Vec3& direction)>& stops_light) {
  WorldData& data = impl_->data;
  data.remembered = find_remembered_casters(
      data, [&](const RememberedCaster& caster, const GeometryRay& ray, const ShapeHit& hit) {
        SurfacePoint surface;
        surface_point(ray.origin, ray.direction,
                      as_hit(hit, static_cast<uint32_t>(caster.instance + 1)), surface);
        return stops_light(surface, ray.direction);
      });
}

bool World::closest_hit_of_remembered(const Vec3& origin, const Vec3& unit_direction, double max_t,
                                      Hit& hit) const {
  const WorldData& data = impl_->data;
  const GeometryRay ray(origin, unit_direction, kShadowRay);
  ShapeHit found;
  const RememberedCaster* caster =
      closest_of_remembered(data, data.remembered, ray, max_t, scratch(), found);
  if (!caster) return false;
  hit = as_hit(found, static_cast<uint32_t>(caster->instance + 1));
  return true;
}

bool World::closest_hit_of_projected(int light, const Vec3& origin, const Vec3& unit_direction,
                                     double& t) const {
  const WorldData& data = impl_->data;
  const int64_t node = data.projected[light];
  if (node < 0) return false;
  ShapeHit hit;
  const GeometryRay ray(origin, unit_direction, kShadowRay);
  if (!data.geometry.closest(static_cast<uint32_t>(node), ray, kHugeDepth, scratch(), hit)) {
    return false;
  }
  t = hit.t;
  return true;
}

// `moved_from`, `moved_to`: a shared object's first WorldObject, and that of the copy asked.
int World::Impl::containing(const ObjectSet& set, const Vec3& point, int64_t moved_from,
                            int64_t moved_to, int* interiors, int capacity) const {
  // Grows to what the scene needs and stays; copies put theirs behind those of what holds them.
  thread_local std::vector<uint32_t> around;
  const size_t first = around.size();
  const auto ask = [&](uint32_t object) {
    const TopLevelObject& top = set.objects[object];
    if (!top.box.contains(point)) return;
    if (top.instance >= 0 || data.geometry.inside_unclipped(top.node, point)) {
      around.push_back(object);
    }
  };
  for (const SearchItem& item : set.all.infinite) ask(item.object);
  set.all.bvh.visit_point(point, [&](uint32_t position) {
    ask(set.all.finite[position].object);
    return false;
  });
  const size_t last = around.size();
  if (last - first > 1) set.put_in_order_of_hierarchy(std::span(around).subspan(first));

  int count = 0;
  for (size_t i = first; i < last && count < capacity; ++i) {
    const TopLevelObject& top = set.objects[around[i]];
    if (top.instance >= 0) {
      const Instance& copy = data.instances[top.instance];
      const SharedGroup& group = *data.groups[copy.group];
      count += containing(group.set, copy.transform.inverse_point(point), group.first_object,
                          copy.first_object, interiors + count, capacity - count);
    } else {
      const int64_t object = data.geometry.nodes[top.node].object;
      interiors[count++] = data.objects[object - moved_from + moved_to].interior;
    }
  }
  around.resize(first);
  return count;
}

int World::containing_interiors(const Vec3& point, int* interiors, int capacity) const {
  return impl_->containing(impl_->data.scene, point, 0, 0, interiors, capacity);
}

const std::vector<CompiledTexture>& World::textures() const {
  return impl_->data.textures;
}
const InteriorTable& World::interiors() const {
  return impl_->data.interiors;
}
const std::vector<IndirectSettings>& World::indirect_settings() const {
  return impl_->data.indirect;
}
const std::vector<WorldLight>& World::lights() const {
  return impl_->data.lights;
}
const std::vector<LightGroup>& World::light_groups() const {
  return impl_->data.light_groups;
}
Bounds World::bounds() const {
  return impl_->data.scene.all.bvh.bounds();
}

}  // namespace durer
