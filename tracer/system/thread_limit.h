// The thread count that the user gave, for every phase of the program.
#pragma once

namespace durer {

// How many threads oneTBB, and with it Embree, may use, the calling one included, from the next
// enforce_thread_limit() to the end of the program.
void limit_threads(int threads);
// To be called before any use of oneTBB or Embree. Most small scenes get by without: starting oneTBB
// takes a few milliseconds.
void enforce_thread_limit();

}  // namespace durer
