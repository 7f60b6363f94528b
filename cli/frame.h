// One picture from the scene's text to the file: parse, build, render, write.
#pragma once

#include <string>

#include "cli/console.h"
#include "cli/options.h"
#include "cli/statistics.h"

namespace durer {

// What differs from frame to frame.
struct FrameSettings {
  int number = 0;      // frame_number of the scene; 0: no animation
  double clock = 0;
  bool clock_given = false;
  std::string scene_path;   // as found
  std::string suffix;       // of the picture's name: the frame number's digits
};

enum class FrameOutcome { done, already_there, stopped };

// The scene could not be read, or a file not be written. The message is on the fatal stream already.
class FrameFailure {};

// Throws FrameFailure, NotSupported. Statistics are added to `run`.
FrameOutcome render_frame(const Options& options, const FrameSettings& frame, Console& console,
                          RunStatistics& run);

}  // namespace durer
