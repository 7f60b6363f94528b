#include "cli/shell.h"

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <iterator>

namespace durer {

std::string expand_command(const std::string& command, const ShellContext& context) {
  // The command word itself is taken as it is.
  const size_t parameters = std::min(command.find_first_of(" \t"), command.size());
  std::string out = command.substr(0, parameters);
  for (size_t i = parameters; i < command.size(); ++i) {
    if (command[i] != '%' || i + 1 == command.size()) {
      out += command[i];
      continue;
    }
    char clock[64];
    std::snprintf(clock, sizeof clock, "%f", context.clock);
    switch (command[++i]) {
      case 'o':
        out += context.output_file;
        break;
      case 's':
        out += context.input_file;
        break;
      case 'n':
        out += std::to_string(context.frame);
        break;
      case 'k':
        out += clock;
        break;
      case 'h':
        out += std::to_string(context.height);
        break;
      case 'w':
        out += std::to_string(context.width);
        break;
      case '%':
        out += '%';
        break;
      default:
        out += '%';
        out += command[i];
    }
  }
  return out;
}

ShellOutcome shell_outcome(const ShellCommand& command, int exit_status) {
  if ((exit_status == 0) != command.on_success) return ShellOutcome::go_on;
  switch (command.action) {
    case 'S':
      return ShellOutcome::skip;
    case 'A':
      return ShellOutcome::skip_all;
    case 'Q':
      return ShellOutcome::quit;
    case 'U':
      return ShellOutcome::user_abort;
    case 'F':
      return ShellOutcome::fatal;
    default:
      return ShellOutcome::go_on;
  }
}

std::string outcome_message(ShellEvent event, ShellOutcome outcome) {
  constexpr const char* kEvents[] = {"Pre_Scene",  "Pre_Frame",  "Post_Frame",
                                     "Post_Scene", "User_Abort", "Fatal_Error"};
  static_assert(std::size(kEvents) == static_cast<size_t>(ShellEvent::count));
  const std::string name = kEvents[static_cast<size_t>(event)];
  const bool one_frame = outcome == ShellOutcome::skip && event == ShellEvent::pre_frame;
  const char* meaning = one_frame                             ? "this frame is left out"
                        : outcome == ShellOutcome::quit       ? "the run ends"
                        : outcome == ShellOutcome::user_abort ? "the run is stopped"
                        : outcome == ShellOutcome::fatal      ? "the run has failed"
                                                              : "all that is left is left out";
  return name + "_Command, and what " + name + "_Return says of its exit status: " + meaning;
}

ShellOutcome run_shell_command(const ShellCommand& command, const ShellContext& context,
                               bool allowed, std::string& refusal) {
  if (command.command.empty()) return ShellOutcome::go_on;
  if (!allowed) {
    refusal = "command not run (allow it with --allow-shell): " + command.command;
    return shell_outcome(command, 1);
  }
  const size_t last = command.command.find_last_not_of(" \t");
  if (last != std::string::npos && command.command[last] == '&') {
    refusal = "commands in the background are not run: " + command.command;
    return shell_outcome(command, 1);
  }
  const int status = std::system(expand_command(command.command, context).c_str());
  return shell_outcome(command, WIFEXITED(status) ? WEXITSTATUS(status) : 1);
}

}  // namespace durer
