// How many shapes an object stands for once its copies are written out: names let a short text double
// them again and again.
#pragma once

#include <unordered_map>

#include "tracer/scene/object.h"

namespace durer {

// Each node is looked at once. Must not outlive the objects.
class PartCount {
 public:
  double of(const ObjectNode& object);

 private:
  std::unordered_map<const ObjectNode*, double> known_;
};

}  // namespace durer
