// Ctrl-C and its kin: a render in progress is asked to stop, anything else ends at once.
#pragma once

#include <atomic>

namespace durer {

// Catches SIGINT, SIGTERM, SIGQUIT and SIGPIPE.
void catch_interrupts();
// Set by the first signal while a render runs; rendering looks at it before each block.
std::atomic<bool>& stop_requested();
// Between these two a signal only sets stop_requested(); outside it ends the run with status 2.
void begin_stoppable();
void end_stoppable();

}  // namespace durer
