#include "cli/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <cstring>

namespace durer {
namespace {

// A signal handler can reach nothing but variables with static storage.
std::atomic<bool> stop{false};
std::atomic<bool> stoppable{false};

void write_text(const char* text) {
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

void handle(int) {
  if (stoppable.load() && !stop.exchange(true)) {
    write_text("\ndurer: stopping after the blocks in hand (again: at once)\n");
    return;
  }
  // Nothing worth keeping, or asked twice.
  write_text("\ndurer: stopped\n");
  _exit(2);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = handle;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  // A file that grows beyond the user's limit is a failed write, not the end of the program.
  signal(SIGXFSZ, SIG_IGN);
  for (int number : {SIGINT, SIGTERM, SIGQUIT, SIGPIPE}) sigaction(number, &action, nullptr);
}

std::atomic<bool>& stop_requested() { return stop; }
void begin_stoppable() { stoppable = true; }
void end_stoppable() { stoppable = false; }

}  // namespace durer
