#include "parser/statements/needless_bounds.h"

#include <algorithm>

#include "tracer/scene/light.h"

namespace durer {
namespace {

// What an object's statement and those that it copies say about its bounds.
struct Said {
  bool bounds = false, clips = false;
  std::optional<bool> split_union;
};

Said what_is_said(const ObjectNode& object) {
  Said said;
  for (const ObjectNode* node = &object; node; node = node->base.get()) {
    for (auto m = node->modifiers.rbegin(); m != node->modifiers.rend(); ++m) {
      said.bounds |= std::holds_alternative<AddBounds>(*m) ||
                     std::holds_alternative<ShareClipsAsBounds>(*m);
      said.clips |= std::holds_alternative<AddClips>(*m) ||
                    std::holds_alternative<ShareBoundsAsClips>(*m);
      const auto* flag = std::get_if<SetFlag>(&*m);
      if (flag && flag->flag == ObjectFlag::split_union && !said.split_union) {
        said.split_union = flag->value;
      }
    }
  }
  return said;
}

// Shapes that are finite whatever their numbers are. Of the others the tracer is asked.
// `known`: finite CSG that was looked at already.
bool is_surely_finite(const ObjectNode& object, std::unordered_set<const CsgNode*>& known) {
  const ShapeNode& shape = shape_of(object);
  const auto is_finite = [&](const ObjectPtr& child) { return is_surely_finite(*child, known); };
  if (const auto* csg = std::get_if<CsgNode>(&shape)) {
    if (known.contains(csg)) return true;
    const bool finite = csg->kind == CsgKind::intersection || csg->kind == CsgKind::difference
                            ? is_finite(csg->children.front())
                            : std::all_of(csg->children.begin(), csg->children.end(), is_finite);
    if (finite) known.insert(csg);
    return finite;
  }
  return !std::holds_alternative<PlaneNode>(shape) &&
         !std::holds_alternative<Rare<QuadricNode>>(shape) &&
         !std::holds_alternative<PolyNode>(shape) &&
         !std::holds_alternative<std::shared_ptr<const LightNode>>(shape);
}

}  // namespace

bool NeedlessBounds::is_finite(const ObjectPtr& object) {
  std::unordered_set<const CsgNode*> known;
  if (is_surely_finite(*object, known)) return true;
  if (std::holds_alternative<std::shared_ptr<const LightNode>>(shape_of(*object))) return false;
  const Bounds box = parser_.queries().extents(object);
  const Vec3 size = box.max - box.min;
  constexpr double kInfiniteVolume = 2e10;
  return size.x * size.y * size.z <= kInfiniteVolume;
}

int NeedlessBounds::count_in_members(const std::shared_ptr<const ShapeNode>& shape) {
  const auto* csg = std::get_if<CsgNode>(shape.get());
  if (!csg || clean_.contains(shape)) return 0;
  int found = 0;
  for (const ObjectPtr& child : csg->children) found += count(child);
  // Of copies the members are looked at once.
  if (found == 0) clean_.insert(shape);
  return found;
}

int NeedlessBounds::count_of_union(const ShapeNode& shape) {
  const auto* csg = std::get_if<CsgNode>(&shape);
  if (csg && !std::all_of(csg->children.begin(), csg->children.end(),
                          [&](const ObjectPtr& child) { return is_finite(child); })) {
    return 0;
  }
  parser_.warning("this union needs no bounds");
  return 1;
}

int NeedlessBounds::count(const ObjectPtr& object) {
  const ObjectNode* origin = object.get();
  while (origin->base) origin = origin->base.get();
  const ShapeNode& shape = *origin->shape;
  const Said said = what_is_said(*object);
  const auto* csg = std::get_if<CsgNode>(&shape);
  if (std::holds_alternative<Rare<TextNode>>(shape) || (csg && csg->kind == CsgKind::union_)) {
    if (said.clips || !said.split_union.value_or(true)) return 0;
    const bool bounded = said.bounds && !(csg && csg->is_light_group);
    return bounded ? count_of_union(shape) : count_in_members(origin->shape);
  }
  if (!said.bounds || csg || std::holds_alternative<PolyNode>(shape) ||
      !parser_.options().remove_bounds) {
    return 0;
  }
  parser_.warning("these bounds are not needed and are taken away");
  return 1;
}

}  // namespace durer
