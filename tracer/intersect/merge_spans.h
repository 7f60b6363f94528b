// Where a ray is within convex members of a merge: what it hits there is not on the merge's surface,
// and no other member needs to be asked. At the ends of the spans the inside tests decide.
#pragma once

#include <algorithm>
#include <cstdint>

#include "tracer/intersect/convex_sweep.h"

namespace durer {

class MergeSpans {
 public:
  // Spans beyond these are left out: their members are asked.
  static constexpr int kMost = 64;

  void add(double from, double to, uint32_t member) {
    if (count_ < kMost) span_[count_++] = {from, to, member};
  }
  // How far on from a hit of a member all that others are hit at lies well within some member; 0: the
  // hit itself may be seen.
  double covered_from(double t, uint32_t member) const {
    double covered = 0;
    for (int i = 0; i < count_; ++i) {
      const Span& span = span_[i];
      if (span.from + border(t) < t && t < span.to - border(t) && span.member != member) {
        covered = std::max(covered, span.to - border(span.to));
      }
    }
    return covered;
  }

 private:
  static double border(double t) { return kSweepDoubt * (1 + t); }

  struct Span {
    double from, to;
    uint32_t member;
  };
  Span span_[kMost];
  int count_ = 0;
};

}  // namespace durer
