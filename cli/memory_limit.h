// A bound for what a scene can make the program allocate.
#pragma once

namespace durer {

// Allocations beyond this many megabytes fail (std::bad_alloc) instead of bringing the machine down;
// 0: as many as the machine has.
void limit_memory(double megabytes);

}  // namespace durer
