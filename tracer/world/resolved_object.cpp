#include "tracer/world/resolved_object.h"

#include <algorithm>

#include "tracer/shapes/plane.h"
#include "tracer/shapes/quadric.h"

namespace durer {
namespace {

constexpr double kLongestFiniteEdge = 1e6;

// The half-space of an axis-parallel plane as a box (14.1).
void clip_to_half_space(Bounds& box, const ResolvedObject& object) {
  const auto& plane = static_cast<const Plane&>(*object.shape);
  Vec3 n = plane.unit_normal();
  double d = plane.distance();
  if (object.has_transform) {
    // The reference turns the normal the wrong way; pictures depend on it. How far the plane is moved
    // counts along the normal as written (measured on povray 3.7).
    const Matrix& forward = object.transform->forward;
    d += dot(n, forward.row[3]) + 1;
    n = forward.transposed_direction(n);
    d -= dot(object.transform->inverse.transposed_direction(n), n);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    if (std::abs(n[axis]) > kGeometryEpsilon && std::abs(n[a]) <= kGeometryEpsilon &&
        std::abs(n[b]) <= kGeometryEpsilon) {
      if (n[axis] > 0) {
        box.max[axis] = std::min(box.max[axis], d);
      } else {
        box.min[axis] = std::max(box.min[axis], -d);
      }
    }
  }
}

FloatBox infinite_if_huge(const FloatBox& box) {
  for (const float edge : box.length) {
    if (edge > static_cast<float>(kLongestFiniteEdge)) return FloatBox();
  }
  return box;
}

// The automatic box of a quadric within a range; kept if it is smaller than the one it has.
void bound_quadric(ResolvedObject& object, const Bounds& range) {
  const auto& quadric = static_cast<const Quadric&>(*object.shape);
  object.box_from_quadric |= quadric.has_automatic_bounds();
  Bounds found;
  const bool is_aslant = quadric.is_aslant();
  if (is_aslant) {
    found = range;
  } else if (!quadric.bounds_within(range, found)) {
    return;
  }
  const FloatBox box = FloatBox::from(found);
  if (box.volume() >= object.box.volume()) return;
  object.box = is_aslant ? box : infinite_if_huge(box);
  object.box_from_quadric |= !is_aslant;
}

// Where it stands when a clip is written; later moves take the box along.
void bound_clipped_quadric(ResolvedObject& object) {
  Bounds range = Bounds::everything();
  for (const ResolvedObject& clip : object.clips) {
    if (clip.is_plane && clip.shape) {
      clip_to_half_space(range, clip);
    } else if (!clip.inverted) {
      range.clip(clip.box.to_bounds());
    }
  }
  bound_quadric(object, range);
}

// Box of a CSG from its members' (6.6).
FloatBox csg_box(ResolvedObject& csg) {
  const bool is_intersection = csg.csg == CsgKind::intersection || csg.csg == CsgKind::difference;
  Bounds box = is_intersection ? Bounds::everything() : Bounds();
  if (is_intersection) {
    for (ResolvedObject& child : csg.children) {
      if (child.kind == ResolvedObject::Kind::light || child.is_quadric || child.is_height_field) {
        continue;
      }
      if (child.is_plane && child.shape) {
        clip_to_half_space(box, child);
      } else if (!child.inverted && !(child.kind == ResolvedObject::Kind::csg && child.inverted)) {
        box.clip(child.box.to_double_bounds());
      }
    }
    for (ResolvedObject& child : csg.children) {
      if (!child.is_quadric || !child.shape || child.inverted) continue;
      bound_quadric(child, box);
      box.clip(child.box.to_double_bounds());
    }
  } else {
    for (const ResolvedObject& child : csg.children) {
      if (child.kind == ResolvedObject::Kind::light && child.children.empty()) continue;
      box.extend(child.box.to_double_bounds());
    }
  }
  if (box.is_empty()) return FloatBox();
  const FloatBox result = FloatBox::from(box);
  if (result.volume() >= FloatBox().volume()) return FloatBox();
  return infinite_if_huge(result);
}

// The box that a bound or clip list installs (4.2).
void install_box(ResolvedObject& object, const std::vector<ResolvedObject>& list) {
  if (list.empty()) return;
  Bounds box = Bounds::everything();
  for (const ResolvedObject& member : list) {
    if (member.is_plane && member.shape) continue;
    if (!member.inverted) box.clip(member.box.to_bounds());
  }
  FloatBox result;
  for (int i = 0; i < 3; ++i) {
    result.lower[i] = static_cast<float>(box.min[i]);
    result.length[i] = static_cast<float>(box.max[i] - box.min[i]);
  }
  if (result.volume() < object.box.volume()) object.box = result;
}

std::shared_ptr<const LightNode> moved(const LightNode& light, const Transform& transform) {
  auto node = std::make_shared<LightNode>(light);
  node->location = transform.point(light.location);
  node->point_at = transform.point(light.point_at);
  node->axis1 = transform.direction(light.axis1);
  node->axis2 = transform.direction(light.axis2);
  if (light.projected_through) {
    auto through = std::make_shared<ObjectNode>();
    through->base = light.projected_through;
    through->position = light.projected_through->position;
    through->modifiers.push_back(transform);
    node->projected_through = through;
  }
  return node;
}

}  // namespace

void ResolvedObject::recompute_box() {
  if (!shape || is_quadric) return;
  const Bounds local = shape->bounds();
  if (is_plane || !local.is_bounded()) {
    // A move forgets the box of bounded_by.
    box = clips.empty() ? FloatBox() : clips.front().box;
  } else if (!has_transform) {
    box = FloatBox::from(local);
  } else {
    box = FloatBox::from(local).transformed(transform);
  }
}

void ResolvedObject::expand() {
  if (kind != Kind::copy) return;
  ResolvedObject whole = *original;
  if (has_transform) whole.move(transform);
  whole.box = box;
  whole.default_texture = default_texture;
  whole.is_csg_child = is_csg_child;
  *this = std::move(whole);
}

void ResolvedObject::move(const Transform& by) {
  if (kind == Kind::copy) {
    transform = has_transform ? transform->then(by) : by;
    has_transform = true;
    box = box.transformed(by);
    return;
  }
  switch (kind) {
    case Kind::shape:
      if (shape) {
        std::shared_ptr<const Shape> taken = has_transform ? nullptr : shape->transformed(by);
        if (taken) {
          shape = std::move(taken);
        } else {
          if (auto beside = has_transform ? nullptr : shape->beside_transform()) shape = beside;
          transform = has_transform ? transform->then(by) : by;
          has_transform = true;
        }
      }
      break;
    case Kind::light: light = moved(*light, by); break;
    case Kind::csg:
      box = box.transformed(by);
      break;
    case Kind::copy: break;
  }
  for (ResolvedObject& child : children) child.move(by);
  if (!bounds_are_clips) {
    for (ResolvedObject& bound : bounds) bound.move(by);
  }
  for (ResolvedObject& clip : clips) clip.move(by);
  if (kind == Kind::shape) {
    // A mesh's box grows with every turn, too: its vertices are not asked again.
    const bool is_mesh = written && std::holds_alternative<Rare<MeshNode>>(*written);
    if (is_quadric || is_mesh) {
      box = box.transformed(by);
    } else {
      recompute_box();
    }
  }
  if (!uv_mapping) {
    texture.move(by);
    interior_texture.move(by);
  }
  if (interior && !interior->media.empty()) {
    interior_transform = interior_moved ? interior_transform->then(by) : by;
    interior_moved = true;
  }
}

void ResolvedObject::invert() {
  expand();
  if (kind == Kind::shape) {
    if (!shape) return;
    if (auto turned = shape->inverted()) shape = std::move(turned);
    if (shape->takes_inverse_mark()) inverted = !inverted;
    return;
  }
  if (kind == Kind::light) return;
  for (ResolvedObject& child : children) child.invert();
  const bool was_intersection = csg == CsgKind::intersection || csg == CsgKind::difference;
  csg = was_intersection ? CsgKind::merge : CsgKind::intersection;
  written_as_difference = false;
  inverted = !inverted;
}

bool ResolvedObject::has_inside() const {
  if (kind == Kind::copy) return original->has_inside();
  if (kind == Kind::light) return false;
  if (kind == Kind::shape) return shape == nullptr || !shape->is_patch();
  return std::all_of(children.begin(), children.end(),
                     [](const ResolvedObject& c) { return c.has_inside(); });
}

bool ResolvedObject::has_texture_anywhere() const {
  if (kind == Kind::copy) return true;  // only textured objects are shared
  if (texture) return true;
  if (kind == Kind::shape) return shape && !shape->needs_object_texture();
  return std::any_of(children.begin(), children.end(),
                     [](const ResolvedObject& c) { return c.has_texture_anywhere(); });
}

void ResolvedObject::mark_as_csg_child() {
  is_csg_child = true;
}

namespace {

constexpr int kLeastUses = 8;
constexpr size_t kLeastShapes = 32;

// Whether nothing in it takes the default texture, which differs from copy to copy.
bool is_textured_throughout(const ResolvedObject& object) {
  if (object.texture) return true;
  return object.kind == ResolvedObject::Kind::csg && !object.children.empty() &&
         std::all_of(object.children.begin(), object.children.end(), is_textured_throughout);
}

// What a copy may share: a textured union, to be split, of plain shapes and CSG.
bool can_be_shared(const ResolvedObject& object, bool is_root, size_t& shapes) {
  if (object.kind == ResolvedObject::Kind::light || object.kind == ResolvedObject::Kind::copy) {
    return false;
  }
  if (object.cutaway_textures || object.is_light_group || object.box.is_infinite()) return false;
  if (is_root && (object.kind != ResolvedObject::Kind::csg || object.csg != CsgKind::union_ ||
                  !is_textured_throughout(object) || !object.clips.empty() || !object.bounds.empty() ||
                  object.bounds_are_clips || !object.split_union)) {
    return false;
  }
  if (object.kind == ResolvedObject::Kind::shape) {
    ++shapes;
    if (object.shape && object.shape->own_textures()) return false;
  }
  return std::all_of(
      object.children.begin(), object.children.end(),
      [&](const ResolvedObject& child) { return can_be_shared(child, false, shapes); });
}

// Only of nodes with more than one owner: the others are used once.
void count_uses(const ObjectPtr& object, std::unordered_map<ObjectPtr, int>& uses) {
  const ObjectNode& node = *object;
  if (object.use_count() > 1 && ++uses[object] > 1) return;
  if (node.base) count_uses(node.base, uses);
  if (!node.shape) return;
  if (const auto* csg = std::get_if<CsgNode>(node.shape.get())) {
    for (const ObjectPtr& child : csg->children) count_uses(child, uses);
  }
}

}  // namespace

void ObjectResolver::find_shared(const std::vector<ObjectPtr>& scene) {
  std::unordered_map<ObjectPtr, int> uses;
  for (const ObjectPtr& object : scene) count_uses(object, uses);
  for (const auto& [node, count] : uses) {
    if (count >= kLeastUses && node->shape && std::holds_alternative<CsgNode>(*node->shape)) {
      shared_.emplace(node, nullptr);
    }
  }
}

// The object that another one copies: as a copy where it may be shared.
ResolvedObject ObjectResolver::resolve_base(const ObjectNode& object) {
  const auto found = shared_.find(object.base);
  if (found == shared_.end()) return resolve(object.base);
  if (!found->second) {
    auto original = std::make_shared<ResolvedObject>(resolve(object.base));
    size_t shapes = 0;
    if (!can_be_shared(*original, true, shapes) || shapes < kLeastShapes) {
      shared_.erase(object.base);
      return std::move(*original);
    }
    shared_[object.base] = std::move(original);
  }
  ResolvedObject copy;
  copy.kind = ResolvedObject::Kind::copy;
  copy.original = shared_[object.base];
  copy.box = copy.original->box;
  return copy;
}

ResolvedObject ObjectResolver::resolve(const ObjectPtr& object) {
  ResolvedObject result = object->base ? resolve_base(*object) : resolve_shape(*object);
  const bool was_difference = result.written_as_difference;
  bool changes_boxes = false;
  for (const Modifier& modifier : object->modifiers) {
    apply(result, modifier, object->base != nullptr);
    changes_boxes |= std::holds_alternative<AddBounds>(modifier) ||
                     std::holds_alternative<AddClips>(modifier);
  }
  if (was_difference && !object->base) result.written_as_difference = true;
  // `inverse` within a julia_fractal's own statement has no effect.
  if (object->shape && result.shape && std::holds_alternative<Rare<JuliaFractalNode>>(*object->shape)) {
    result.shape = result.shape->transformed(Transform());
  }
  if (changes_boxes && result.is_plane && result.shape && !result.clips.empty()) {
    result.box = result.clips.front().box;
  }
  // Every statement installs them again, also one that only moves a copy. The own statement of a
  // height_field or blob sets its box last.
  const bool keeps_box = object->shape && (result.is_height_field ||
                                           std::holds_alternative<BlobNode>(*object->shape));
  if (!keeps_box) {
    if (!result.bounds_are_clips) install_box(result, result.bounds);
    install_box(result, result.clips);
  }
  return result;
}

// Each returns what it has made where the caller wants it: ResolvedObject is large.
ResolvedObject ObjectResolver::resolve_shape(const ObjectNode& object) {
  const ShapeNode& node = *object.shape;
  if (const auto* csg = std::get_if<CsgNode>(&node)) return resolve_csg(*csg);
  if (std::holds_alternative<Rare<TextNode>>(node)) return resolve_text(object.shape);
  if (const auto* light = std::get_if<std::shared_ptr<const LightNode>>(&node)) {
    return resolve_light(*light);
  }
  return resolve_primitive(object);
}

ResolvedObject ObjectResolver::resolve_light(const std::shared_ptr<const LightNode>& light) {
  ResolvedObject result;
  result.kind = ResolvedObject::Kind::light;
  result.light = light;
  if (light->looks_like) {
    result.children.push_back(resolve(light->looks_like));
    result.children.back().expand();
    result.children.back().no_shadow = true;
    result.children.back().mark_as_csg_child();
  }
  result.no_shadow = true;
  return result;
}

ResolvedObject ObjectResolver::resolve_primitive(const ObjectNode& object) {
  ResolvedObject result;
  const ShapeNode& node = *object.shape;
  const PlacedShape placed = compiled(object);
  result.shape = placed.shape;
  result.written = &node;
  result.shape_kind = static_cast<uint8_t>(node.index());
  result.has_transform = placed.has_transform;
  result.transform = placed.transform;
  result.is_plane = std::holds_alternative<PlaneNode>(node);
  result.is_quadric = std::holds_alternative<Rare<QuadricNode>>(node);
  result.is_height_field = std::holds_alternative<HeightFieldNode>(node);
  if (!result.shape) return result;
  if (result.is_quadric) {
    bound_quadric(result, Bounds::everything());
  } else {
    const Bounds local = result.shape->bounds();
    if (!result.has_transform) {
      result.box = FloatBox::from(local);
    } else if (local.is_bounded()) {
      result.box = FloatBox::from(local).transformed(result.transform);
    }
  }
  return result;
}

namespace {

// The same shape with another way of finding roots.
ShapeNode with_sturm(const ShapeNode& node, bool sturm) {
  ShapeNode changed = node;
  std::visit(
      [&](auto& shape) {
        if constexpr (requires { shape.sturm; }) shape.sturm = sturm;
      },
      changed);
  return changed;
}

}  // namespace

PlacedShape ObjectResolver::compiled(const ObjectNode& object) {
  const ShapeContext context{effective_version_};
  // `sturm` is written among the modifiers but belongs to the shape.
  for (auto modifier = object.modifiers.rbegin(); modifier != object.modifiers.rend(); ++modifier) {
    const auto* flag = std::get_if<SetFlag>(&*modifier);
    if (flag && flag->flag == ObjectFlag::sturm) {
      return compile_shape(with_sturm(*object.shape, flag->value), context);
    }
  }
  return shapes_.shape(object.shape, context);
}

ResolvedObject ObjectResolver::resolve_csg(const CsgNode& node) {
  ResolvedObject result;
  result.kind = ResolvedObject::Kind::csg;
  result.csg = node.kind;
  result.is_light_group = node.is_light_group;
  result.global_lights = node.global_lights;
  result.children.reserve(node.children.size());
  for (const ObjectPtr& child : node.children) {
    result.children.push_back(resolve(child));
    ResolvedObject& member = result.children.back();
    if (node.kind != CsgKind::union_) member.expand();
    if (node.kind == CsgKind::difference && result.children.size() > 1) member.invert();
    member.mark_as_csg_child();
  }
  if (node.kind == CsgKind::difference) {
    result.csg = CsgKind::intersection;
    result.written_as_difference = true;
  }
  result.box = csg_box(result);
  return result;
}

// A union of its characters, turned a little.
ResolvedObject ObjectResolver::resolve_text(const std::shared_ptr<const ShapeNode>& node) {
  ResolvedObject result;
  result.kind = ResolvedObject::Kind::csg;
  result.csg = CsgKind::union_;
  for (const PlacedGlyph& glyph : shapes_.text(node)) {
    ResolvedObject member;
    member.shape = glyph.shape;
    member.shape_kind = static_cast<uint8_t>(ShapeNode(std::in_place_type<Rare<TextNode>>).index());
    member.is_csg_child = true;
    member.move(Transform::translation(glyph.offset));
    result.children.push_back(std::move(member));
  }
  result.box = csg_box(result);
  result.move(Transform::rotation(Vec3(kTextRotationDegrees)));
  return result;
}

void ObjectResolver::apply(ResolvedObject& object, const Modifier& modifier, bool is_copy) {
  if (!std::holds_alternative<Rare<Transform>>(modifier) &&
      !std::holds_alternative<SetDefaultTexture>(modifier)) {
    object.expand();
  }
  if (const auto* transform = std::get_if<Rare<Transform>>(&modifier)) {
    object.move(*transform);
  } else if (const auto* texture = std::get_if<SetTexture>(&modifier)) {
    object.texture = {texture->texture, {}};
  } else if (const auto* fallback = std::get_if<SetDefaultTexture>(&modifier)) {
    object.default_texture = fallback->texture;
  } else if (const auto* inner = std::get_if<SetInteriorTexture>(&modifier)) {
    object.interior_texture = {inner->texture, {}};
  } else if (const auto* interior = std::get_if<SetInterior>(&modifier)) {
    object.interior = interior->interior;
    object.interior_moved = false;
  } else if (const auto* add = std::get_if<AddBounds>(&modifier)) {
    auto& list = object.bounds_are_clips ? object.clips : object.bounds;
    for (const ObjectPtr& bound : *add->objects) {
      list.push_back(resolve(bound));
      list.back().expand();
    }
  } else if (const auto* clips = std::get_if<AddClips>(&modifier)) {
    for (const ObjectPtr& clip : *clips->objects) {
      object.clips.push_back(resolve(clip));
      object.clips.back().expand();
    }
    if (object.is_quadric && object.shape) bound_clipped_quadric(object);
  } else if (std::holds_alternative<ShareBoundsAsClips>(modifier)) {
    object.clips = std::move(object.bounds);
    object.bounds.clear();
    object.bounds_are_clips = true;
  } else if (std::holds_alternative<ShareClipsAsBounds>(modifier)) {
    object.bounds_are_clips = true;
  } else if (const auto* photons = std::get_if<SetPhotons>(&modifier)) {
    object.photons = photons->photons;
  } else if (const auto* importance = std::get_if<SetRadiosityImportance>(&modifier)) {
    object.radiosity_importance = importance->importance;
  } else if (const auto* flag = std::get_if<SetFlag>(&modifier)) {
    const bool value = flag->value;
    const auto for_all = [](ResolvedObject& root, auto&& self, auto&& set) -> void {
      root.expand();
      set(root);
      for (ResolvedObject& child : root.children) self(child, self, set);
    };
    switch (flag->flag) {
      case ObjectFlag::hollow:
        for_all(object, for_all, [&](ResolvedObject& o) {
          if (&o == &object || !o.hollow_given) o.hollow = value;
        });
        object.hollow_given = true;
        break;
      case ObjectFlag::double_illuminate:
        for_all(object, for_all, [&](ResolvedObject& o) { o.double_illuminate = value; });
        break;
      case ObjectFlag::no_image: object.no_image = value; break;
      case ObjectFlag::no_reflection: object.no_reflection = value; break;
      case ObjectFlag::no_radiosity: object.no_radiosity = value; break;
      case ObjectFlag::no_shadow: object.no_shadow = value; break;
      case ObjectFlag::split_union: object.split_union = value; break;
      case ObjectFlag::cutaway_textures: object.cutaway_textures = value; break;
      case ObjectFlag::uv_mapping: object.uv_mapping = value; break;
      case ObjectFlag::inverse: object.invert(); break;
      case ObjectFlag::global_lights: object.global_lights = value; break;
      case ObjectFlag::sturm:
        // Of a copy; in the shape's own statement compiled() has seen to it.
        if (object.shape && is_copy) {
          object.shape =
              compile_shape(with_sturm(*object.written, value), {effective_version_}).shape;
        }
        break;
      case ObjectFlag::hierarchy: break;  // changes nothing that is seen
    }
  }
}

}  // namespace durer
