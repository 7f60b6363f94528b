#include "cli/run.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>

#include "cli/console.h"
#include "cli/frame.h"
#include "cli/help.h"
#include "cli/interrupt.h"
#include "cli/memory_limit.h"
#include "cli/option_reader.h"
#include "cli/options.h"
#include "cli/output_name.h"
#include "cli/setting_notes.h"
#include "cli/shell.h"
#include "parser/diagnostics.h"
#include "parser/source.h"
#include "tracer/system/thread_limit.h"
#include "tracer/scene/not_supported.h"

namespace durer {
namespace {

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

void complain(const std::string& text) { std::fprintf(stderr, "durer: %s\n", text.c_str()); }

bool write_text_file(const std::string& path, const std::string& text) {
  if (path == "-") {
    print(text);
    return std::fflush(stdout) == 0;
  }
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  return (std::fclose(file) == 0) && written;
}

bool is_file(const std::string& path) {
  struct stat status;
  return stat(path.c_str(), &status) == 0 && !S_ISDIR(status.st_mode);
}

// The scene, with its extension appended if it was left out; in the current folder, then in the
// library paths (spec/language.md 16). Empty: not found.
std::string find_scene(const Options& options) {
  const std::string& name = options.input_file;
  std::vector<std::string> candidates;
  const bool complete = name.size() > 4 && (name.compare(name.size() - 4, 4, ".pov") == 0 ||
                                            name.compare(name.size() - 4, 4, ".POV") == 0);
  if (complete) candidates.push_back(name);
  candidates.push_back(name + ".pov");
  candidates.push_back(name + ".POV");
  if (!complete) candidates.push_back(name);
  for (const std::string& candidate : candidates) {
    if (is_file(candidate)) return candidate;
    if (name[0] == '/') continue;
    for (const std::string& folder : options.library_paths) {
      const std::string path = folder + (folder.back() == '/' ? "" : "/") + candidate;
      if (is_file(path)) return path;
    }
  }
  return "";
}

std::string line_of_file(const std::string& path, int line) {
  std::string text;
  if (!read_file(path, UINT32_MAX, text)) return {};
  NameTable names;
  const uint32_t end = static_cast<uint32_t>(text.size());
  SourceFile file(path, std::move(text), names);
  file.line_of(end);
  return file.line_text(line);
}

// The place may be unknown: that of a scene without further ado.
Diagnostic diagnostic_of(const NotSupported& missing, const std::string& scene) {
  const SourcePosition& place = missing.position;
  Diagnostic diagnostic;
  diagnostic.severity = Severity::not_supported;
  diagnostic.text = missing.what();
  diagnostic.file = place.file ? *place.file : scene;
  diagnostic.line = place.line;
  diagnostic.column = place.column;
  if (place.line > 0) diagnostic.source_line = line_of_file(diagnostic.file, place.line);
  return diagnostic;
}

// Ends the run with this status; messages are out already.
struct EndOfRun {
  int status;
};

class Run {
 public:
  explicit Run(const Options& options) : options_(options) {}

  int render_all(const std::vector<std::string>& notes) {
    try {
      const std::string first_output = output_of(options_.animation.start);
      console_.open(options_, folder_of(first_output),
                    options_.append_files || options_.continue_trace);
      for (const std::string& note : notes) console_.line(Stream::warning, "durer: note: " + note);
      find();
      return finish(frames());
    } catch (const OptionError& error) {
      complain(error.what());
      return kFailure;
    } catch (const EndOfRun& end) {
      return finish(end.status);
    } catch (const FrameFailure&) {
      return finish(failed(kFailure));
    } catch (const NotSupported& missing) {
      console_.diagnostic(diagnostic_of(missing, options_.input_file));
      return finish(failed(kNotSupported));
    } catch (const std::bad_alloc&) {
      console_.line(Stream::fatal, "durer: out of memory (--max-memory MB sets the limit)");
      return finish(failed(kFailure));
    } catch (const std::runtime_error& failure) {  // of a file that was there while the scene was read
      console_.line(Stream::fatal, std::string("durer: error: ") + failure.what());
      return finish(failed(kFailure));
    }
  }

 private:
  std::string output_of(int frame) const {
    return is_standard_stream(options_.output_name)
               ? options_.output_name
               : output_path(options_.input_file, options_.output_name, options_.file_type,
                             options_.animation.frame_suffix(frame));
  }

  void find() {
    scene_path_ = find_scene(options_);
    if (scene_path_.empty()) {
      console_.line(Stream::fatal, "durer: there is no scene '" + options_.input_file + "'");
      throw FrameFailure();
    }
  }

  // Runs an event's command and applies its return action, as far as it ends the run.
  ShellOutcome run_event(ShellEvent event, int frame, double clock) {
    const ShellContext context{output_of(frame), file_part_of(options_.input_file), frame,
                               options_.render.width, options_.render.height, clock};
    std::string refusal;
    const ShellOutcome outcome = run_shell_command(options_.commands[static_cast<size_t>(event)],
                                                   context, options_.allow_shell, refusal);
    if (!refusal.empty()) console_.line(Stream::warning, "durer: " + refusal);
    if (outcome == ShellOutcome::go_on) return outcome;
    const bool ends_run = event == ShellEvent::user_abort || event == ShellEvent::fatal_error;
    if (!ends_run) {
      console_.line(Stream::warning, "durer: " + outcome_message(event, outcome));
      if (outcome == ShellOutcome::user_abort) run_event(ShellEvent::user_abort, frame, clock);
      if (outcome == ShellOutcome::fatal) run_event(ShellEvent::fatal_error, frame, clock);
    }
    // Behind the last frame there is nothing left to end.
    if (event == ShellEvent::post_scene) return ShellOutcome::go_on;
    switch (outcome) {
      case ShellOutcome::quit:
        throw EndOfRun{kSuccess};
      case ShellOutcome::user_abort:
      case ShellOutcome::fatal:
        throw EndOfRun{kFailure};
      default:
        return outcome;
    }
  }

  int failed(int status) {
    try {
      run_event(ShellEvent::fatal_error, frame_, clock_);
    } catch (const EndOfRun& end) {
      return end.status;
    }
    return status;
  }

  int frames() {
    const Animation& animation = options_.animation;
    const ShellOutcome before = run_event(ShellEvent::pre_scene, 0, 0);
    if (before == ShellOutcome::skip || before == ShellOutcome::skip_all) return kSuccess;
    const int start = animation.on ? animation.start : 0;
    const int end = animation.on ? animation.end : 0;
    // 64 bits: the step may lead past the largest int.
    for (int64_t number = start; number <= end; number += animation.step) {
      frame_ = static_cast<int>(number);
      const bool running = animation.on;
      clock_ = running ? animation.clock(frame_) : options_.clock;
      if (running) {
        console_.line(Stream::render, "Frame " + std::to_string(frame_) + " of " +
                                          std::to_string(animation.start) + " to " +
                                          std::to_string(animation.end));
      }
      const ShellOutcome pre = run_event(ShellEvent::pre_frame, frame_, clock_);
      if (pre == ShellOutcome::skip_all) break;
      if (pre == ShellOutcome::skip) continue;
      const FrameSettings settings{frame_, clock_, running || options_.clock_given, scene_path_,
                                   animation.frame_suffix(frame_)};
      if (render_frame(options_, settings, console_, run_) == FrameOutcome::stopped) {
        run_event(ShellEvent::user_abort, frame_, clock_);
        return kStopped;
      }
      // Both skips are of all frames that remain.
      if (run_event(ShellEvent::post_frame, frame_, clock_) != ShellOutcome::go_on) break;
    }
    run_event(ShellEvent::post_scene, frame_, clock_);
    return kSuccess;
  }

  int finish(int status) {
    run_.scene = scene_path_;
    run_.width = options_.render.width;
    run_.height = options_.render.height;
    run_.threads = options_.render.threads;
    if (!options_.stats_file.empty() &&
        !write_text_file(options_.stats_file, statistics_json(run_))) {
      complain("cannot write '" + options_.stats_file + "': " + std::strerror(errno));
      if (status == kSuccess) status = kFailure;
    }
    return status;
  }

  const Options& options_;
  Console console_;
  RunStatistics run_;
  std::string scene_path_;
  int frame_ = 0;
  double clock_ = 0;
};

bool is_one_of(const std::string& argument, std::initializer_list<const char*> words) {
  for (const char* word : words) {
    if (argument == word) return true;
  }
  return false;
}

}  // namespace

int run(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (is_one_of(argument, {"--help", "-help", "-h", "-?"})) {
      print(help_text());
      return kSuccess;
    }
    if (is_one_of(argument, {"--version", "-version", "--V"})) {
      print(version_text());
      return kSuccess;
    }
    if (is_one_of(argument, {"--benchmark", "-benchmark"})) {
      complain("POV-Ray's benchmark scene is not part of this program; `reference/speed` in the "
               "sources measures");
      return kFailure;
    }
  }
  catch_interrupts();
  OptionValues values;
  OptionReader reader(values);
  Options options;
  std::vector<std::string> notes;
  const bool compare_methods = !arguments.empty() && arguments.front() == "compare-methods";
  try {
    reader.read_main_ini();
    reader.read_arguments({arguments.begin() + (compare_methods ? 1 : 0), arguments.end()});
    reader.add_library_paths_of_the_system();
    options = resolve_options(values);
    options.compare_methods = compare_methods;
    notes = reader.notes();
    for (std::string& note : setting_notes(values, options)) notes.push_back(std::move(note));
  } catch (const OptionError& error) {
    complain(error.what());
    return kFailure;
  }
  if (!options.create_ini.empty() && !write_text_file(options.create_ini, values.to_ini())) {
    complain("cannot write '" + options.create_ini + "': " + std::strerror(errno));
    return kFailure;
  }
  if (options.input_file.empty()) {
    complain("no scene is given. Try: durer scene.pov +W800 +H600, or durer --help");
    return kFailure;
  }
  limit_memory(options.max_memory);
  limit_threads(options.render.threads);
  return Run(options).render_all(notes);
}

}  // namespace durer
