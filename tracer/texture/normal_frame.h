// Normals on their way into the space of a pattern and back (spec/textures.md 14.2, 14.6).
#pragma once

#include <vector>

#include "tracer/scene/pattern.h"

namespace durer {

// Of the warps of one pattern: only transforms touch a normal.
class NormalFrame {
 public:
  NormalFrame() = default;
  // keep_length: no_bump_scale.
  NormalFrame(const std::vector<Warp>& warps, bool keep_length) : keep_length_(keep_length) {
    for (auto it = warps.rbegin(); it != warps.rend(); ++it) {
      if (const auto* transform = std::get_if<Transform>(&*it)) chain_.push_back(*transform);
    }
  }

  bool does_nothing() const { return chain_.empty(); }
  // Of length 1 before and after, even where nothing moves it: the last digits are POV-Ray's (measured
  // by mirrors of a sky that jumps at length 1).
  Vec3 inwards(Vec3 n) const {
    n = of_length_1(n);
    for (const Transform& t : chain_) n = t.inverse_normal(n);
    return of_length_1(n);
  }
  Vec3 outwards(Vec3 n) const {
    n = of_length_1(n);
    for (auto it = chain_.rbegin(); it != chain_.rend(); ++it) n = it->normal(n);
    return of_length_1(n);
  }

 private:
  Vec3 of_length_1(const Vec3& n) const { return keep_length_ ? n : unit_or_zero(n); }

  std::vector<Transform> chain_;  // as applied to a point: last written first
  bool keep_length_ = false;
};

// The patterned textures around the layer that is shaded, outermost first. POV-Ray takes none off
// its list while it goes through the entries of a map, nor do we.
class EnclosingFrames {
 public:
  void enter(const NormalFrame& frame) {
    if (!frame.does_nothing() && count_ < kMost) frames_[count_++] = &frame;
  }
  Vec3 inwards(Vec3 n) const {
    for (int i = 0; i < count_; ++i) n = frames_[i]->inwards(n);
    return n;
  }
  Vec3 outwards(Vec3 n) const {
    for (int i = count_ - 1; i >= 0; --i) n = frames_[i]->outwards(n);
    return n;
  }

 private:
  static constexpr int kMost = 128;
  const NormalFrame* frames_[kMost];
  int count_ = 0;
};

}  // namespace durer
