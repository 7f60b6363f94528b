// What rays that fly close together share of their walks.
#pragma once

#include "tracer/intersect/bvh.h"

namespace durer {

// Where rays that fly close together enter a hierarchy: what any of them may meet, near ones first.
struct BvhBeam {
  static constexpr int kGroups = 4;

  int groups = 0;
  BvhNode group[kGroups];  // children as in the hierarchy's own nodes
  float near[kGroups];     // no ray enters this group or a later one before
};

}  // namespace durer
