// The walks through a Bvh, compiled twice from bvh_kernel.inc: for any x86-64 and for x86-64-v3.
#pragma once

#include <cstdint>

#include "tracer/intersect/bvh.h"

namespace durer {

struct BvhRayQuery {
  const BvhNode* nodes;
  float origin[3];
  float inverse[3];  // of the direction; infinite where that is 0
  double t_offset;   // what the true origin lies before `origin`
  double t_max;      // from the true origin
  BvhRayVisitor visitor;
  void* context;
};
struct BvhPointQuery {
  const BvhNode* nodes;
  float point[3];
  BvhPointVisitor visitor;
  void* context;
};

namespace base_kernel {
void visit_ray(const BvhRayQuery& query);
void visit_point(const BvhPointQuery& query);
}  // namespace base_kernel
namespace v3_kernel {
void visit_ray(const BvhRayQuery& query);
void visit_point(const BvhPointQuery& query);
}  // namespace v3_kernel

}  // namespace durer
