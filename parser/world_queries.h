// SceneQueries answered by the tracer.
#pragma once

#include <memory>

#include "parser/scene_queries.h"

namespace durer {

class Parser;

// The parser tells the version by which objects are compiled; it must outlive the result.
std::shared_ptr<SceneQueries> make_world_queries(const Parser& parser);

}  // namespace durer
