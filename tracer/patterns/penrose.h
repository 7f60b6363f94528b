// The aperiodic tilings 25 (pentagons), 26 (kites and darts), 27 (rhombs).
#pragma once

namespace durer {

// Value in 0..1 at (x, z); number 25..27 (spec/textures.md 8.1).
double penrose_tiling(int number, double x, double z);

}  // namespace durer
