#include "tracer/intersect/bvh_kernel.h"

namespace durer::base_kernel {

#include "tracer/intersect/bvh_kernel.inc"

}  // namespace durer::base_kernel
