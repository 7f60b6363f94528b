// A font for a scene whose own is not there.
#pragma once

#include <string>

namespace durer {

// The file of an installed font that comes nearest to the named font file: one of the same file name
// wherever it lies, else what fontconfig gives for the family and style that the name stands for
// ("arialbd.ttf": Arial, bold). Empty: the machine has no outline fonts.
std::string replacement_font(const std::string& name);

}  // namespace durer
