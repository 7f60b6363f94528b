// What --help and --version print.
#pragma once

#include <string>

namespace durer {

std::string help_text();
std::string version_text();
// One option of the table as the help and the man page show it: "+W640, --width 640, Width=640".
struct OptionEntry;
std::string option_spelling(const OptionEntry& entry);

}  // namespace durer
