// The thread count that the user gave, for every phase of the program.
#pragma once

namespace durer {

// From here to the end of the program oneTBB, and with it Embree, uses at most so many threads, the
// calling one included. Called again: the least counts.
void limit_threads(int threads);

}  // namespace durer
