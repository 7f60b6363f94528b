// One run of the command: settings, then frame after frame.
#pragma once

#include <string>
#include <vector>

namespace durer {

// Exit statuses (spec/language.md 36; 3 is Dürer's own).
inline constexpr int kSuccess = 0, kFailure = 1, kStopped = 2, kNotSupported = 3;

// The arguments without the command's name. Returns the exit status.
int run(const std::vector<std::string>& arguments);

}  // namespace durer
