// Commands that an INI file asks to be run (spec/language.md 37). Off unless the user allows them.
#pragma once

#include <string>

#include "cli/options.h"

namespace durer {

struct ShellContext {
  std::string output_file, input_file;
  int frame = 0, width = 0, height = 0;
  double clock = 0;
};

// What happens next.
enum class ShellOutcome { go_on, skip, skip_all, quit, user_abort, fatal };

// %o %s %n %k %h %w %% replaced in the parameters, not in the command word.
std::string expand_command(const std::string& command, const ShellContext& context);
// The outcome of a command that ended with this status.
ShellOutcome shell_outcome(const ShellCommand& command, int exit_status);
// What such an outcome, other than go_on, of an event's command means, for the user.
std::string outcome_message(ShellEvent event, ShellOutcome outcome);
// Runs it and waits. Refused commands count as failed, with a message in `refusal`.
ShellOutcome run_shell_command(const ShellCommand& command, const ShellContext& context,
                               bool allowed, std::string& refusal);

}  // namespace durer
