#include "cli/animation.h"

#include <algorithm>
#include <cstdio>

namespace durer {
namespace {

// A subset's bound: up to 0 the whole, below 1 a share of the frames, from 1 on a frame number.
int subset_frame(double bound, int first, int last, int otherwise) {
  if (bound <= 0) return otherwise;
  if (bound < 1) {
    // The product is rounded to single precision: 0.29 of 100 frames is 29, not 28.
    return static_cast<int>(static_cast<float>((last - first + 1) * bound));
  }
  return static_cast<int>(std::min(bound, 2e9));
}

}  // namespace

double Animation::clock(int frame) const {
  return static_cast<float>(clock_delta * (frame - first) + initial_clock);
}

std::string Animation::frame_suffix(int frame) const {
  if (!on) return "";
  char text[32];
  const int digits = std::snprintf(text, sizeof text, "%d", last);
  std::snprintf(text, sizeof text, "%0*d", digits, frame);
  return text;
}

Animation animation_from(const OptionValues& values) {
  Animation animation;
  const int initial = values.integer(Option::initial_frame, 0);
  const int final_frame = values.integer(Option::final_frame, 0);
  // Both 0 or both 1 is a single picture.
  animation.on = !(initial == final_frame && (initial == 0 || initial == 1));
  if (!animation.on) return animation;

  animation.first = std::max(values.is_set(Option::initial_frame) ? initial : 1, 0);
  const int whole_last =
      std::max(values.is_set(Option::final_frame) ? final_frame : 1, animation.first);
  const bool cyclic = values.toggle(Option::cyclic_animation, false);
  animation.last = whole_last + (cyclic ? 1 : 0);
  animation.step = std::max(values.integer(Option::frame_step, 1), 1);
  animation.initial_clock = values.number(Option::initial_clock, 0);
  animation.final_clock = values.number(Option::final_clock, 1);
  // An animation of one frame divides by zero, as POV-Ray's does: its clock is NaN.
  animation.clock_delta = (animation.final_clock - animation.initial_clock) /
                          static_cast<double>(animation.last - animation.first);

  animation.start = std::max(subset_frame(values.number(Option::subset_start_frame, 0),
                                          animation.first, animation.last, animation.first),
                             animation.first);
  animation.end = std::max(subset_frame(values.number(Option::subset_end_frame, 0),
                                        animation.first, animation.last, whole_last),
                           animation.start);
  return animation;
}

}  // namespace durer
