// The search in a map (spec/textures.md 10): entries keep the order of the text.
#pragma once

#include <emmintrin.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "tracer/scene/texture.h"

namespace durer {

// Two entries to blend: result = lower + share·(upper - lower). lower == upper where one serves.
struct MapPlace {
  int lower;
  int upper;
  double share;
};

// Of two colours, rounded as POV-Ray rounds it (measured on povray 3.7).
inline ColorRGBFT blend(const ColorRGBFT& lower, const ColorRGBFT& upper, double share) {
  const auto part = [share](float low, float high) {
    return low + static_cast<float>(static_cast<double>(high - low) * share);
  };
  return {part(lower.red, upper.red), part(lower.green, upper.green),
          part(lower.blue, upper.blue), part(lower.filter, upper.filter),
          part(lower.transmit, upper.transmit)};
}

// Where a map's entries lie.
class MapPositions {
 public:
  template <typename Item>
  explicit MapPositions(const std::vector<MapEntry<Item>>& entries)
      : last_(static_cast<int>(entries.size()) - 1) {
    for (const auto& entry : entries) positions_.push_back(static_cast<double>(entry.position));
    ascends_ = std::is_sorted(positions_.begin(), positions_.end());
    // Pairs are looked at.
    if (positions_.size() % 2) positions_.push_back(std::numeric_limits<double>::infinity());
  }

  MapPlace find(double value) const {
    if (value >= positions_[last_]) return {last_, last_, 0};
    const int upper = first_from(value);
    if (upper == 0 || value == positions_[upper]) return {upper, upper, 0};
    // Both are of single precision, and so is the width between them.
    const double low = positions_[upper - 1], high = positions_[upper];
    return {upper - 1, upper, (value - low) / static_cast<double>(static_cast<float>(high - low))};
  }

 private:
  // The first entry that is not below a value; there is one.
  int first_from(double value) const {
    if (!ascends_) [[unlikely]] {
      int first = 0;
      while (value > positions_[first]) ++first;
      return first;
    }
    // Counted, not looked for: where a search ends processors cannot guess.
    const __m128d sought = _mm_set1_pd(value);
    __m128i below = _mm_setzero_si128();
    for (size_t i = 0; i < positions_.size(); i += 2) {
      const __m128d pair = _mm_loadu_pd(&positions_[i]);
      below = _mm_sub_epi64(below, _mm_castpd_si128(_mm_cmplt_pd(pair, sought)));
    }
    return _mm_cvtsi128_si32(_mm_add_epi64(below, _mm_unpackhi_epi64(below, below)));
  }

  std::vector<double> positions_;
  int last_;
  bool ascends_;
};

}  // namespace durer
