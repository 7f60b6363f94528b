#include <algorithm>

#include "tracer/world/world_builder.h"

namespace durer {

struct ObjectQuery::Impl {
  WorldData data;
  uint32_t node = 0;
  FloatBox box, extents;
  bool is_exempt = false;
  bool has_inside = true;
};

namespace {

// Light sources have no bounds, and neither have unions with one in them.
bool is_unbounded_by_light(const ResolvedObject& object) {
  if (object.kind == ResolvedObject::Kind::light) return true;
  if (object.kind == ResolvedObject::Kind::copy) return is_unbounded_by_light(*object.original);
  if (object.kind != ResolvedObject::Kind::csg || !object.clips.empty() || !object.bounds.empty()) {
    return false;
  }
  const bool is_union = object.csg == CsgKind::union_ || object.csg == CsgKind::merge;
  return is_union && std::any_of(object.children.begin(), object.children.end(), is_unbounded_by_light);
}

}  // namespace

ObjectQuery::ObjectQuery() : impl_(std::make_unique<Impl>()) {}
ObjectQuery::~ObjectQuery() = default;

std::shared_ptr<const ObjectQuery> ObjectQuery::build(const ObjectPtr& object,
                                                      int effective_version) {
  CompiledShapes shapes;
  return build(object, effective_version, shapes);
}

std::shared_ptr<const ObjectQuery> ObjectQuery::build(const ObjectPtr& object,
                                                      int effective_version,
                                                      CompiledShapes& shapes) {
  std::shared_ptr<ObjectQuery> query(new ObjectQuery);
  Impl& impl = *query->impl_;
  ObjectResolver resolver(shapes, effective_version);
  const ResolvedObject resolved = resolver.resolve(object);
  WorldBuilder builder(impl.data, {}, nullptr, {});
  impl.node = builder.add_bare(resolved);
  impl.box = resolved.box;
  impl.extents = is_unbounded_by_light(resolved) ? FloatBox() : resolved.box;
  impl.has_inside = resolved.has_inside();
  const GeometryNode& node = impl.data.geometry.nodes[impl.node];
  impl.is_exempt = node.kind == NodeKind::shape && node.shape->is_exempt_from_box_test();
  return query;
}

bool ObjectQuery::trace(const Vec3& origin, const Vec3& unit_direction, Vec3& point,
                        Vec3& normal) const {
  thread_local HitStack stack;
  const Geometry& geometry = impl_->data.geometry;
  const GeometryRay ray{origin, unit_direction, kImageRay | kPrimaryRay};
  if (!impl_->is_exempt && !impl_->box.is_met(origin, unit_direction)) return false;
  if (!geometry.passes_bounds(geometry.nodes[impl_->node], ray, stack)) return false;
  ShapeHit hit;
  if (!geometry.closest(impl_->node, ray, kHugeDepth, stack, hit)) return false;
  const GeometryNode& node = geometry.nodes[hit.node];
  point = geometry.hit_point(node, ray, hit);
  if (node.transform >= 0) {
    const Transform& transform = geometry.transforms[node.transform];
    normal = transform.normal(node.shape->normal(transform.inverse_point(point), hit));
  } else {
    normal = node.shape->normal(point, hit);
  }
  const bool has_unit_length = node.transform < 0 && node.shape->has_unit_normal(hit);
  if (!has_unit_length) normal = normal * (1 / length(normal));
  if (node.inverted) normal = -normal;
  return true;
}

bool ObjectQuery::inside(const Vec3& point) const {
  return impl_->data.geometry.inside(impl_->node, point);
}
bool ObjectQuery::has_inside() const { return impl_->has_inside; }
Bounds ObjectQuery::extents() const { return impl_->extents.to_bounds(); }

}  // namespace durer
