#include "tracer/intersect/bvh_kernel.h"

namespace durer::v3_kernel {

#include "tracer/intersect/bvh_kernel.inc"

}  // namespace durer::v3_kernel
