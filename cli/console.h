// Messages: five streams, each on the console (standard error) and, if wished, in a file.
#pragma once

#include <array>
#include <cstdio>
#include <mutex>
#include <string>

#include "cli/options.h"
#include "parser/diagnostics.h"

namespace durer {

class Console : public MessageSink {
 public:
  Console() = default;
  ~Console() override;
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  // Opens the streams' files in `folder` (empty or with a final slash). Throws OptionError.
  void open(const Options& options, const std::string& folder, bool append);

  // Whole lines; the final newline is added. Safe from several threads.
  void line(Stream stream, const std::string& text);
  // The line at the bottom of a terminal that is written again and again; empty: wipe it away.
  void status(const std::string& text);
  bool is_terminal() const;
  int columns() const;  // of the terminal, 80 if unknown

  void diagnostic(const Diagnostic& message) override;
  void debug_line(const std::string& text) override;

  int warnings() const { return warnings_; }

 private:
  struct Output {
    bool console = true;
    std::FILE* file = nullptr;
  };
  void wipe_status();
  void close();

  std::array<Output, kStreamCount> outputs_;
  std::FILE* all_file_ = nullptr;
  std::string status_;
  std::mutex mutex_;
  int warnings_ = 0;
};

// "1.2 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

}  // namespace durer
