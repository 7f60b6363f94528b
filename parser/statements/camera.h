// camera{...}, after the word (spec/shading.md 3.2).
#pragma once

#include <memory>

#include "tracer/scene/camera.h"

namespace durer {

class Parser;

std::shared_ptr<const CameraNode> parse_camera(Parser& parser);

}  // namespace durer
