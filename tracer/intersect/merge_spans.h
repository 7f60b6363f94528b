// Where a ray is within convex members of a merge: what it hits there is not on the merge's surface,
// and no other member needs to be asked. At the ends of the spans the inside tests decide.
#pragma once

#include <algorithm>

#include "tracer/intersect/convex_sweep.h"

namespace durer {

class MergeSpans {
 public:
  // Where the ray enters a member and leaves it.
  void add(double enters, double leaves) {
    Span fresh{enters + border(enters), leaves - border(leaves)};
    if (fresh.from >= fresh.to) return;
    // It takes in those that it overlaps.
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      if (span_[i].to < fresh.from || span_[i].from > fresh.to) {
        span_[kept++] = span_[i];
      } else {
        fresh = {std::min(fresh.from, span_[i].from), std::max(fresh.to, span_[i].to)};
      }
    }
    if (kept < kMost) span_[kept++] = fresh;
    count_ = kept;
  }
  // How far on from a place on the ray all lies within members; 0: it may be on the surface. Members
  // are hit at the ends of their own spans, which lie outside of these.
  double covered_from(double t) const {
    for (int i = 0; i < count_; ++i) {
      if (span_[i].from < t && t < span_[i].to) return span_[i].to;
    }
    return 0;
  }

 private:
  struct Span {
    double from, to;
  };
  static double border(double t) { return kSweepDoubt * (1 + t); }

  // Spans beyond these are left out: their members are asked.
  static constexpr int kMost = 32;
  Span span_[kMost];  // apart from each other
  int count_ = 0;
};

}  // namespace durer
