// The search in a map (spec/textures.md 10): entries keep the order of the text.
#pragma once

#include "tracer/scene/texture.h"

namespace durer {

// Two entries to blend: result = lower + share·(upper - lower). lower == upper where one serves.
struct MapPlace {
  int lower;
  int upper;
  float share;
};

template <typename Item>
MapPlace find_in_map(const std::vector<MapEntry<Item>>& entries, double value) {
  const int last = static_cast<int>(entries.size()) - 1;
  if (value >= entries[last].position) return {last, last, 0};
  int upper = 0;
  while (value > entries[upper].position) ++upper;
  if (upper == 0 || value == entries[upper].position) return {upper, upper, 0};
  const double low = entries[upper - 1].position, high = entries[upper].position;
  return {upper - 1, upper, static_cast<float>((value - low) / (high - low))};
}

}  // namespace durer
