// How far one word is from another: for "did you mean".
#pragma once

#include <string_view>

namespace durer {

// Letters lost, added, replaced or swapped with their neighbour on the way from a to b; case counts
// half. In halves, and given up above `most`.
int edit_distance(std::string_view a, std::string_view b, int most);

}  // namespace durer
