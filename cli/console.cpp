#include "cli/console.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstring>

namespace durer {

Console::~Console() { close(); }

void Console::close() {
  for (Output& output : outputs_) {
    if (output.file) std::fclose(output.file);
    output.file = nullptr;
  }
  if (all_file_) std::fclose(all_file_);
  all_file_ = nullptr;
}

void Console::open(const Options& options, const std::string& folder, bool append) {
  close();
  const char* mode = append ? "ab" : "wb";
  auto open_file = [&](const std::string& name) -> std::FILE* {
    if (name.empty()) return nullptr;
    std::FILE* file = std::fopen((folder + name).c_str(), mode);
    if (!file) throw OptionError("cannot write '" + folder + name + "': " + std::strerror(errno));
    return file;
  };
  for (size_t i = 0; i < outputs_.size(); ++i) {
    outputs_[i].console = options.streams[i].console;
    outputs_[i].file = open_file(options.streams[i].file);
  }
  all_file_ = open_file(options.all_file);
}

bool Console::is_terminal() const { return isatty(STDERR_FILENO) != 0; }

int Console::columns() const {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

void Console::wipe_status() {
  if (status_.empty()) return;
  std::fputs("\r\x1b[K", stderr);
}

void Console::line(Stream stream, const std::string& text) {
  const std::lock_guard lock(mutex_);
  Output& output = outputs_[static_cast<size_t>(stream)];
  const std::string whole = text + "\n";
  if (output.console) {
    wipe_status();
    std::fwrite(whole.data(), 1, whole.size(), stderr);
    std::fputs(status_.c_str(), stderr);
  }
  for (std::FILE* file : {output.file, all_file_}) {
    if (file) std::fwrite(whole.data(), 1, whole.size(), file);
  }
}

void Console::status(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (!outputs_[static_cast<size_t>(Stream::render)].console) return;
  wipe_status();
  status_ = text;
  std::fputs(status_.c_str(), stderr);
}

void Console::diagnostic(const Diagnostic& message) {
  const bool error = message.severity >= Severity::error;
  if (!error && message.severity != Severity::note) ++warnings_;
  std::string text = message.formatted();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  line(error ? Stream::fatal : Stream::warning, text);
}

void Console::debug_line(const std::string& text) {
  constexpr size_t kColumns = 80;  // whatever the terminal has
  std::string rest = text;
  while (rest.size() > kColumns) {
    const size_t end = line_break(rest, kColumns);
    line(Stream::debug, rest.substr(0, end));
    rest.erase(0, end);
  }
  line(Stream::debug, rest);
}

std::string duration_text(double seconds) {
  char text[64];
  if (seconds < 9.95) {
    std::snprintf(text, sizeof text, seconds < 0.095 ? "%.2f s" : "%.1f s", seconds);
  } else if (seconds < 60) {
    std::snprintf(text, sizeof text, "%.0f s", std::floor(seconds));
  } else if (seconds < 3600) {
    const int whole = static_cast<int>(seconds);
    std::snprintf(text, sizeof text, "%d min %d s", whole / 60, whole % 60);
  } else {
    const long minutes = static_cast<long>(seconds / 60);
    std::snprintf(text, sizeof text, "%ld h %ld min", minutes / 60, minutes % 60);
  }
  return text;
}

}  // namespace durer
