// What a user is told, one line each, about settings that are obeyed in another way than their
// words say: numbers out of range, and settings that others make ineffective.
#pragma once

#include <string>
#include <vector>

#include "cli/options.h"

namespace durer {

std::vector<std::string> setting_notes(const OptionValues& values, const Options& options);

}  // namespace durer
