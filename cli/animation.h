// Which frames there are, and the clock of each (spec/language.md 33).
#pragma once

#include <string>

#include "cli/option_values.h"

namespace durer {

struct Animation {
  bool on = false;
  int first = 1, last = 1;  // last: one more in a cyclic animation, and then not rendered
  int start = 1, end = 1;   // the subset that is rendered now
  int step = 1;
  double initial_clock = 0, final_clock = 1;
  double clock_delta = 0;

  // Single precision, as POV-Ray keeps it. NaN in an animation of one frame.
  double clock(int frame) const;
  // Zero-padded to the digits of `last`; empty when there is no animation.
  std::string frame_suffix(int frame) const;
};

Animation animation_from(const OptionValues& values);

}  // namespace durer
