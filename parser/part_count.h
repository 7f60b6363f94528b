// How many shapes an object stands for once its copies are written out: names let a short text double
// them again and again.
#pragma once

#include "tracer/scene/object.h"

namespace durer {

// Of an object under construction, its members' being known. Up to rounding.
float part_count(const ObjectNode& object);

}  // namespace durer
