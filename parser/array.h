// array[n1][n2]...: up to five dimensions, all elements of one kind (spec/language.md 15).
#pragma once

#include <array>
#include <vector>

#include "parser/value.h"

namespace durer {

struct ArrayShape {
  static constexpr int kMostDimensions = 5;

  int dimensions = 0;
  std::array<int64_t, kMostDimensions> sizes{};
};

struct Array {
  static constexpr int kMostDepth = 1000;

  ArrayShape shape;
  ValueKind element_kind = ValueKind::unset;  // fixed by the first element ever stored
  std::vector<Value> elements;                // row by row
  int depth = 0;                              // levels of arrays in its elements
};

}  // namespace durer
