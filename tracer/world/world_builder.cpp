#include "tracer/world/world_builder.h"

#include <algorithm>

namespace durer {
namespace {

uint8_t hidden_bits(const ResolvedObject& object) {
  uint8_t bits = 0;
  if (object.no_image) bits |= kImageRay;
  if (object.no_reflection) bits |= kReflectionRay;
  if (object.no_shadow) bits |= kShadowRay | kPhotonRay;
  if (object.no_radiosity) bits |= kRadiosityRay;
  return bits;
}

bool is_union(const ResolvedObject& object) {
  return object.kind == ResolvedObject::Kind::csg && object.csg == CsgKind::union_;
}

template <typename Node>
bool is_shape_of(const ResolvedObject& object) {
  return object.kind == ResolvedObject::Kind::shape &&
         object.shape_kind == ShapeNode(std::in_place_type<Node>).index();
}

NodeKind node_kind(const ResolvedObject& object) {
  switch (object.csg) {
    case CsgKind::union_:
      return NodeKind::union_;
    case CsgKind::merge:
      return NodeKind::merge;
    default:
      return NodeKind::intersection;
  }
}

// A union whose solid members cast no shadow casts none (2.4).
void lift_no_shadow(ResolvedObject& object) {
  if (!is_union(object)) return;
  bool any = false;
  for (const ResolvedObject& child : object.children) {
    if (child.kind == ResolvedObject::Kind::light) continue;
    if (!child.no_shadow) return;
    any = true;
  }
  if (any) object.no_shadow = true;
}

// What a member takes from its parent (section 5, step 1).
void inherit_from(ResolvedObject& object, const ResolvedObject& parent) {
  if (!object.texture) {
    object.texture = parent.texture;
    object.texture.stays |= parent.uv_mapping;
  }
  if (!object.interior_texture) {
    object.interior_texture = parent.interior_texture;
    object.interior_texture.stays |= parent.uv_mapping;
  }
  // Members with a texture of their own are seen at (u, v), too.
  object.uv_mapping_of_parent |= parent.uv_mapping || parent.uv_mapping_of_parent;
  object.no_image |= parent.no_image;
  object.no_reflection |= parent.no_reflection;
  object.no_radiosity |= parent.no_radiosity;
  object.no_shadow |= parent.no_shadow;
  object.cutaway_textures |= parent.cutaway_textures;
  if (object.radiosity_importance < 0) object.radiosity_importance = parent.radiosity_importance;
  const auto share = [](auto& own, const auto& from) {
    if (!own) own = from;
  };
  share(object.photons.target, parent.photons.target);
  share(object.photons.refraction, parent.photons.refraction);
  share(object.photons.reflection, parent.photons.reflection);
  share(object.photons.pass_through, parent.photons.pass_through);
  share(object.photons.collect, parent.photons.collect);
}

// The finish of a plain texture has a say in the interior (spec/shading.md 11.2): of the top layer
// only. Members of a CSG share an interior: the last one that says something counts.
void take_from_finish(WorldInterior& interior, const TextureNode& texture) {
  if (texture.kind != TextureNode::Kind::plain) return;
  static const FinishNode default_finish;
  const FinishNode& finish = texture.finish ? *texture.finish : default_finish;
  if (finish.legacy_ior >= 0) interior.ior = finish.legacy_ior;
  if (finish.legacy_caustics >= 0) interior.caustics = static_cast<double>(finish.legacy_caustics);
  interior.refraction = finish.legacy_refraction >= 0 ? finish.legacy_refraction : 1;
}

}  // namespace

// Objects that follow each other mostly agree: only the last ones are looked at.
uint32_t InteriorTable::kind(const WorldInterior& interior) {
  constexpr size_t kMostCompared = 4;
  const size_t count = kinds_.size();
  for (size_t i = 0; i < kMostCompared && i < count; ++i) {
    if (kinds_[count - 1 - i] == interior) return static_cast<uint32_t>(count - 1 - i);
  }
  kinds_.push_back(interior);
  return static_cast<uint32_t>(count);
}

int InteriorTable::add(const WorldInterior& interior) {
  kind_of_.push_back(kind(interior));
  return static_cast<int>(kind_of_.size() - 1);
}

int InteriorTable::add_copy(int number) {
  kind_of_.push_back(kind_of_[number]);
  return static_cast<int>(kind_of_.size() - 1);
}

WorldBuilder::WorldBuilder(WorldData& data, const WorldOptions& options, TexturePtr default_texture,
                           const TextureSettings& textures)
    : data_(data),
      options_(options),
      default_texture_(std::move(default_texture)),
      textures_(data.textures, textures),
      set_(&data.scene) {
  if (!default_texture_) default_texture_ = std::make_shared<const TextureNode>();
}

uint32_t WorldBuilder::new_node() {
  node_pages_.before_push(data_.geometry.nodes);
  data_.geometry.nodes.emplace_back();
  appearance_pages_.before_push(data_.appearance);
  data_.appearance.emplace_back();
  return static_cast<uint32_t>(data_.geometry.nodes.size() - 1);
}

void WorldBuilder::expect(size_t objects) {
  data_.geometry.nodes.reserve(objects);
  data_.appearance.reserve(objects);
  data_.objects.reserve(objects);
  data_.scene.objects.reserve(objects);
  data_.textures.reserve(objects);
}

void WorldBuilder::add_top_level(ResolvedObject&& object) {
  if (object.default_texture) default_texture_ = object.default_texture;
  split(std::move(object), -1);
}

// The members of a shared object, emitted once in its own space.
uint32_t WorldBuilder::group_of(const std::shared_ptr<const ResolvedObject>& original) {
  const auto known = groups_.find(original.get());
  if (known != groups_.end()) return known->second;
  const uint32_t index = static_cast<uint32_t>(data_.groups.size());
  groups_.emplace(original.get(), index);
  originals_.push_back(original);
  auto group = std::make_unique<SharedGroup>();
  group->first_object = static_cast<uint32_t>(data_.objects.size());
  group_ = group.get();
  set_ = &group->set;
  split(ResolvedObject(*original), -1);
  set_ = &data_.scene;
  group_ = nullptr;
  group->object_count = static_cast<uint32_t>(data_.objects.size()) - group->first_object;
  finish_set(data_.geometry, group->set, true);
  data_.groups.push_back(std::move(group));
  return index;
}

// A copy has materials of its own: textures moved with it, interiors told apart.
void WorldBuilder::add_instance(const ResolvedObject& copy) {
  const uint32_t index = group_of(copy.original);
  const SharedGroup& group = *data_.groups[index];
  Instance instance{index, copy.has_transform ? *copy.transform : Transform(),
                    static_cast<uint32_t>(data_.objects.size())};
  std::unordered_map<int, int> interiors;
  for (uint32_t i = 0; i < group.object_count; ++i) {
    WorldObject object = data_.objects[group.first_object + i];
    const auto moved = [&](MovedTexture texture) {
      texture.move(instance.transform);
      return textures_.index_of(texture);
    };
    if (group.textures[i]) object.texture = moved(group.textures[i]);
    if (group.interior_textures[i]) object.interior_texture = moved(group.interior_textures[i]);
    const auto [own, is_new] = interiors.try_emplace(object.interior, 0);
    if (is_new) own->second = data_.interiors.add_copy(object.interior);
    object.interior = own->second;
    data_.objects.push_back(object);
  }
  TopLevelObject top;
  top.box = FloatBox::from(instance.transform.bounds(group.set.all.bvh.bounds()));
  top.instance = static_cast<int32_t>(data_.instances.size());
  data_.instances.push_back(std::move(instance));
  set_->objects.push_back(top);
}

int WorldBuilder::add_light_group(const ResolvedObject& group, int parent) {
  data_.light_groups.push_back({group.global_lights, parent});
  return static_cast<int>(data_.light_groups.size()) - 1;
}

void WorldBuilder::split(ResolvedObject&& object, int light_group) {
  if (object.kind == ResolvedObject::Kind::copy) {
    // Only what is just moved stays shared; media know their place.
    const bool is_plain = !group_ && !object.texture && !object.interior_texture &&
                          light_group < 0 && hidden_bits(object) == 0 &&
                          object.shared_interior < 0 && object.radiosity_importance < 0 &&
                          !object.original->interior;
    if (is_plain) {
      add_instance(object);
      return;
    }
    ResolvedObject inherited = object;
    object.expand();
    inherit_from(object, inherited);
    if (!object.interior) object.shared_interior = inherited.shared_interior;
  }
  // Unneeded bounds go (their box stays).
  const bool keeps_bounds = object.kind == ResolvedObject::Kind::csg ||
                            is_shape_of<PolyNode>(object) || is_shape_of<Rare<TextNode>>(object) ||
                            (object.is_quadric && !object.box_from_quadric);
  if (options_.remove_bounds && !keeps_bounds) {
    object.bounds.clear();
  }
  lift_no_shadow(object);
  if (object.is_light_group) light_group = add_light_group(object, light_group);
  const bool has_bounds =
      !object.bounds.empty() || (object.bounds_are_clips && !object.clips.empty());
  const auto is_finite = [](const ResolvedObject& child) { return !child.box.is_infinite(); };
  const bool splits = is_union(object) && object.clips.empty() && object.split_union &&
                      (!has_bounds || object.is_light_group ||
                       (options_.split_unions &&
                        std::all_of(object.children.begin(), object.children.end(), is_finite)));
  if (!splits) {
    const bool is_light = object.kind == ResolvedObject::Kind::light;
    const bool visible = !is_light || !object.children.empty();
    TopLevelObject top;
    top.box = is_light && visible ? object.children[0].box : object.box;
    top.hidden = hidden_bits(object);
    // Only the hierarchy asks what a looks_like says (measured on povray 3.7).
    if (is_light && visible) {
      top.hidden_in_hierarchy = hidden_bits(object.children[0]) & (kImageRay | kReflectionRay);
    }
    const uint32_t node = emit(object, nullptr, -1, light_group, -1);
    if (visible && data_.geometry.nodes[node].kind != NodeKind::nothing) {
      if (!group_) top_level_pages_.before_push(set_->objects);
      top.node = node;
      set_->objects.push_back(top);
    }
    return;
  }
  // The members inherit first, then each stands for itself.
  int interior = -1;
  inherit(object, nullptr, -1, interior);
  for (ResolvedObject& child : object.children) {
    child.is_csg_child = false;
    child.is_light_of_group = object.is_light_group;
    inherit_from(child, object);
    if (child.shared_interior < 0 && !child.interior) child.shared_interior = interior;
    split(std::move(child), light_group);
  }
}

// Section 5, steps 1 to 3, for one object; its interior's number goes to `interior`.
void WorldBuilder::inherit(ResolvedObject& object, const ResolvedObject* parent,
                           int parent_interior, int& interior) {
  if (parent) inherit_from(object, *parent);
  const bool parent_cuts_away = parent && parent->kind == ResolvedObject::Kind::csg &&
                                parent->csg == CsgKind::intersection && parent->cutaway_textures;
  if (!object.texture && object.kind != ResolvedObject::Kind::light &&
      !object.has_texture_anywhere() && !parent_cuts_away) {
    object.texture = {default_texture_, {}};
  }
  // Interior: its own, the parent's, or a new one.
  interior = object.interior ? -1
             : object.shared_interior >= 0 ? object.shared_interior
                                           : parent_interior;
  WorldInterior said;
  if (interior >= 0) {
    said = data_.interiors[interior];
  } else if (object.interior) {
    said.node = object.interior_moved ? transformed(object.interior, object.interior_transform)
                                      : object.interior;
    // Without an ior there is no dispersion either.
    if (said.node->ior != 0) {
      said.ior = said.node->ior;
      said.dispersion = said.node->dispersion;
    }
    said.dispersion_samples = said.node->dispersion_samples;
    said.caustics = 45.0 * static_cast<double>(said.node->caustics);
    said.refraction = said.node->refraction;
  }
  said.hollow = object.hollow;
  if (object.texture) take_from_finish(said, *object.texture.texture);
  if (interior >= 0) {
    data_.interiors.set(interior, said);
  } else {
    interior = data_.interiors.add(said);
  }
}

uint32_t WorldBuilder::indirect_number(const ResolvedObject& object) {
  const IndirectSettings settings{object.photons, object.radiosity_importance};
  if (settings == data_.indirect.front()) return 0;
  if (settings != data_.indirect.back()) data_.indirect.push_back(settings);
  return static_cast<uint32_t>(data_.indirect.size() - 1);
}

uint32_t WorldBuilder::object_number(const WorldObject& object, const ResolvedObject& source) {
  // Members of one CSG follow each other and mostly agree.
  const size_t count = data_.objects.size();
  const size_t first = group_ ? group_->first_object : 0;
  for (size_t i = 0; i < 4 && i < count - first; ++i) {
    if (data_.objects[count - 1 - i] == object) return static_cast<uint32_t>(count - 1 - i);
  }
  object_pages_.before_push(data_.objects);
  data_.objects.push_back(object);
  if (group_) {
    for (auto [list, texture] : {std::pair(&group_->textures, source.texture),
                                 std::pair(&group_->interior_textures, source.interior_texture)}) {
      texture.stays |= source.uv_mapping;
      list->push_back(std::move(texture));
    }
  }
  return static_cast<uint32_t>(count);
}

void WorldBuilder::fill_shape(uint32_t index, const ResolvedObject& object, bool csg_child) {
  GeometryNode& node = data_.geometry.nodes[index];
  if (!object.shape) {
    node.kind = NodeKind::nothing;
    return;
  }
  node.kind = NodeKind::shape;
  node.shape = object.shape.get();
  node.shape_kind = object.shape_kind;
  node.inverted = object.inverted;
  node.csg_child = csg_child;
  if (object.has_transform) {
    node.transform = static_cast<int32_t>(data_.geometry.transforms.size());
    data_.geometry.transforms.push_back(object.transform);
  }
  data_.geometry.shapes.push_back(object.shape);
}

NodeRange WorldBuilder::emit_list(const std::vector<ResolvedObject>& list) {
  if (list.empty()) return {};
  std::vector<uint32_t> nodes;
  for (const ResolvedObject& member : list) nodes.push_back(emit_bare(member, false));
  NodeRange range{static_cast<uint32_t>(data_.geometry.lists.size()),
                  static_cast<uint32_t>(nodes.size())};
  data_.geometry.lists.insert(data_.geometry.lists.end(), nodes.begin(), nodes.end());
  return range;
}

uint32_t WorldBuilder::add_bare(const ResolvedObject& object) {
  return emit_bare(object, false);
}

// Geometry only, for clips, bounds and questions.
uint32_t WorldBuilder::emit_bare(const ResolvedObject& object, bool csg_child) {
  if (object.kind == ResolvedObject::Kind::copy) {
    ResolvedObject whole = object;
    whole.expand();
    return emit_bare(whole, csg_child);
  }
  const uint32_t index = new_node();
  std::vector<uint32_t> children;
  for (const ResolvedObject& child : object.children) {
    children.push_back(emit_bare(child, true));
  }
  const NodeRange clips = emit_list(object.clips);
  const NodeRange bounds = object.bounds_are_clips ? clips : emit_list(object.bounds);
  Geometry& geometry = data_.geometry;
  if (object.kind == ResolvedObject::Kind::shape) {
    fill_shape(index, object, csg_child);
  } else {
    geometry.nodes[index].kind = object.kind == ResolvedObject::Kind::light
                                     ? (children.empty() ? NodeKind::nothing : NodeKind::union_)
                                     : node_kind(object);
    geometry.nodes[index].has_object =
        object.kind != ResolvedObject::Kind::light || !children.empty();
  }
  finish_node(index, object, children, clips, bounds);
  return index;
}

void WorldBuilder::finish_node(uint32_t index, const ResolvedObject& object,
                               const std::vector<uint32_t>& children, const NodeRange& clips,
                               const NodeRange& bounds) {
  Geometry& geometry = data_.geometry;
  GeometryNode& node = geometry.nodes[index];
  node.hidden = hidden_bits(object);
  node.children = {static_cast<uint32_t>(geometry.lists.size()),
                   static_cast<uint32_t>(children.size())};
  geometry.lists.insert(geometry.lists.end(), children.begin(), children.end());
  if (!(object.shape && object.shape->ignores_clips())) node.clips = clips;
  node.bounds = bounds;
  geometry.finish_node(index);
}

uint32_t WorldBuilder::emit(ResolvedObject& object, const ResolvedObject* parent,
                            int parent_interior, int light_group, int32_t filter) {
  int interior = -1;
  inherit(object, parent, parent_interior, interior);
  if (object.is_light_group && parent) light_group = add_light_group(object, light_group);
  const uint32_t index = new_node();

  if (object.kind == ResolvedObject::Kind::light) {
    // Only a group's own lights stay in it; those of a union in it shine everywhere.
    data_.lights.push_back({object.light, object.is_light_of_group ? light_group : -1});
  }

  // Which members lend their textures to untextured surfaces: those of the outermost CSG that
  // sorts hits out.
  const bool sorts_out = object.kind == ResolvedObject::Kind::csg &&
                         (object.csg != CsgKind::union_ || !object.clips.empty());
  const int32_t inner_filter = filter < 0 && sorts_out ? static_cast<int32_t>(index) : filter;
  std::vector<uint32_t> children;
  children.reserve(object.children.size());
  for (ResolvedObject& child : object.children) {
    child.is_light_of_group = object.is_light_group;
    // Of a looks_like only split() asks.
    if (object.kind == ResolvedObject::Kind::light) {
      child.no_image = object.no_image;
      child.no_reflection = object.no_reflection;
    }
    children.push_back(emit(child, &object, interior, light_group, inner_filter));
  }
  const NodeRange clips = emit_list(object.clips);
  const NodeRange bounds = object.bounds_are_clips ? clips : emit_list(object.bounds);

  Geometry& geometry = data_.geometry;
  if (object.kind == ResolvedObject::Kind::shape) {
    fill_shape(index, object, object.is_csg_child && parent);
  } else {
    GeometryNode& node = geometry.nodes[index];
    node.kind = object.kind == ResolvedObject::Kind::light
                    ? (children.empty() ? NodeKind::nothing : NodeKind::union_)
                    : node_kind(object);
    node.has_object = object.kind != ResolvedObject::Kind::light || !children.empty();
    node.written_as_difference = object.written_as_difference;
  }

  // Materials.
  WorldObject material;
  if (object.texture) material.texture = textures_.index_of(object.texture);
  if (object.interior_texture) {
    material.interior_texture = textures_.index_of(object.interior_texture);
  }
  material.interior = interior;
  material.light_group = light_group;
  material.uv_mapping = object.uv_mapping || object.uv_mapping_of_parent;
  material.double_illuminate = object.double_illuminate;
  material.no_shadow = object.no_shadow;
  material.no_image = object.no_image;
  material.no_reflection = object.no_reflection;
  material.no_radiosity = object.no_radiosity;
  material.inverted = object.inverted;
  material.indirect = indirect_number(object);

  NodeAppearance appearance;
  appearance.cutaway_root = object.texture ? -1 : filter;
  appearance.needs_uv = material.uv_mapping;
  appearance.has_unit_normals = object.kind == ResolvedObject::Kind::shape && object.shape &&
                                !object.has_transform && object.shape->has_unit_normals();
  for (const uint32_t texture : {material.texture, material.interior_texture}) {
    if (texture != kNoTexture) appearance.needs_uv |= textures_.uses_uv(texture);
  }
  if (object.kind == ResolvedObject::Kind::shape && object.shape && object.shape->own_textures()) {
    appearance.own_textures = static_cast<int32_t>(data_.own_texture_ids.size());
    const bool is_mesh = object.written && std::holds_alternative<Rare<MeshNode>>(*object.written);
    for (const TexturePtr& texture : *object.shape->own_textures()) {
      MovedTexture own;
      own.texture = texture;
      own.stays = object.uv_mapping && is_mesh;
      if (object.has_transform) own.move(object.transform);
      const uint32_t id = texture ? textures_.index_of(own) : kNoTexture;
      data_.own_texture_ids.push_back(id);
      if (id != kNoTexture) appearance.needs_uv |= textures_.uses_uv(id);
    }
  }
  data_.appearance[index] = appearance;

  geometry.nodes[index].object = object_number(material, object);
  finish_node(index, object, children, clips, bounds);
  return index;
}

void WorldBuilder::resolve_projected(ObjectResolver& resolver) {
  for (const WorldLight& light : data_.lights) {
    data_.projected.push_back(light.node->projected_through
                                  ? static_cast<int64_t>(emit_bare(
                                        resolver.resolve(light.node->projected_through), false))
                                  : -1);
  }
}

void WorldBuilder::finish() {
  // Objects at scene level as written, lights without looks_like among them.
  const size_t count = data_.scene.objects.size() +
                       static_cast<size_t>(std::count_if(
                           data_.lights.begin(), data_.lights.end(),
                           [](const WorldLight& light) { return !light.node->looks_like; }));
  finish_set(data_.geometry, data_.scene, count >= static_cast<size_t>(options_.bounding_threshold));
}

}  // namespace durer
