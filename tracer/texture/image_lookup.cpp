#include "tracer/texture/image_lookup.h"

#include "tracer/scene/not_supported.h"

namespace durer {

std::shared_ptr<const CompiledPigment> compile_image_pigment(const PigmentNode& node,
                                                             const TextureSettings&) {
  throw NotSupported("image_map", node.pattern.position);
}

}  // namespace durer
