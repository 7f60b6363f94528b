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
bool is_surely_finite(const ObjectNode& object) {
  const ShapeNode& shape = shape_of(object);
  const auto is_finite = [](const ObjectPtr& child) { return is_surely_finite(*child); };
  if (const auto* csg = std::get_if<CsgNode>(&shape)) {
    return csg->kind == CsgKind::intersection || csg->kind == CsgKind::difference
               ? is_finite(csg->children.front())
               : std::all_of(csg->children.begin(), csg->children.end(), is_finite);
  }
  return !std::holds_alternative<PlaneNode>(shape) &&
         !std::holds_alternative<Rare<QuadricNode>>(shape) &&
         !std::holds_alternative<PolyNode>(shape) &&
         !std::holds_alternative<std::shared_ptr<const LightNode>>(shape);
}

}  // namespace

bool NeedlessBounds::is_finite(const ObjectPtr& object) {
  if (is_surely_finite(*object)) return true;
  if (std::holds_alternative<std::shared_ptr<const LightNode>>(shape_of(*object))) return false;
  const Bounds box = parser_.queries().extents(object);
  const Vec3 size = box.max - box.min;
  constexpr double kInfiniteVolume = 2e10;
  return size.x * size.y * size.z <= kInfiniteVolume;
}

int NeedlessBounds::count_in_union(const std::vector<ObjectPtr>& children, bool bounded) {
  if (!bounded) {
    int found = 0;
    for (const ObjectPtr& child : children) found += count(child);
    return found;
  }
  if (!std::all_of(children.begin(), children.end(),
                   [&](const ObjectPtr& child) { return is_finite(child); })) {
    return 0;
  }
  parser_.warning("this union needs no bounds");
  return 1;
}

int NeedlessBounds::count(const ObjectPtr& object) {
  const bool shared = object.use_count() > 1;
  if (shared && clean_.contains(object)) return 0;
  const Said said = what_is_said(*object);
  const ShapeNode& shape = shape_of(*object);
  const auto* csg = std::get_if<CsgNode>(&shape);
  const bool is_text = std::holds_alternative<Rare<TextNode>>(shape);
  int found = 0;
  if (is_text || (csg && csg->kind == CsgKind::union_)) {
    if (!said.clips && said.split_union.value_or(true)) {
      found = count_in_union(csg ? csg->children : std::vector<ObjectPtr>{},
                             said.bounds && !(csg && csg->is_light_group));
    }
  } else if (said.bounds && !csg && !std::holds_alternative<PolyNode>(shape) &&
             parser_.options().remove_bounds) {
    parser_.warning("these bounds are not needed and are taken away");
    found = 1;
  }
  if (shared && found == 0) clean_.insert(object);
  return found;
}

}  // namespace durer
