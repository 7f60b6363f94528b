// camera{...}, after the word (spec/shading.md 3.2).
#pragma once

#include <memory>

#include "tracer/scene/camera.h"

namespace durer {

class Parser;

// The text changes a copy of `start`; null: of the default camera.
std::shared_ptr<const CameraNode> parse_camera(Parser& parser,
                                               const std::shared_ptr<const CameraNode>& start = {});

}  // namespace durer
