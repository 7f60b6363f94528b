#include "parser/part_count.h"

#include "tracer/scene/light.h"

namespace durer {

float part_count(const ObjectNode& object) {
  float count = object.base ? object.base->parts : 1;
  const auto add = [&](const std::vector<ObjectPtr>& others) {
    for (const ObjectPtr& other : others) count += other->parts;
  };
  if (object.shape) {
    if (const auto* csg = std::get_if<CsgNode>(object.shape.get())) {
      count = 0;
      add(csg->children);
    } else if (const auto* light =
                   std::get_if<std::shared_ptr<const LightNode>>(object.shape.get())) {
      for (const ObjectPtr& other : {(*light)->looks_like, (*light)->projected_through}) {
        if (other) count += other->parts;
      }
    }
  }
  for (const Modifier& modifier : object.modifiers) {
    if (const auto* bounds = std::get_if<AddBounds>(&modifier)) add(*bounds->objects);
    if (const auto* clips = std::get_if<AddClips>(&modifier)) add(*clips->objects);
  }
  return count;
}

}  // namespace durer
