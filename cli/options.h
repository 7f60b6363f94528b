// Everything that a run was asked to do, resolved, checked and ready to use.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/animation.h"
#include "cli/option_reader.h"
#include "tracer/image/quantize.h"
#include "tracer/sampling/render_options.h"

namespace durer {

enum class Stream { debug, fatal, render, statistic, warning, count };
inline constexpr int kStreamCount = static_cast<int>(Stream::count);

// One console stream: shown, and copied into a file (a bare name, beside the picture).
struct StreamOptions {
  bool console = true;
  std::string file;
};

enum class ShellEvent { pre_scene, pre_frame, post_frame, post_scene, user_abort, fatal_error, count };

struct ShellCommand {
  std::string command;
  char action = 'I';       // I S A Q U F (spec/language.md 37)
  bool on_success = false;  // the action applies to exit status 0 instead
};

// What an ..._Return setting says, "-F": a letter, negated by - or !.
struct ReturnAction {
  char letter = 'I';
  bool is_negated = false;
  bool is_known = false;  // other letters count as I
};
ReturnAction read_return_action(std::string_view text);

struct Options {
  // files
  std::string input_file, include_header;
  std::vector<std::string> library_paths;
  std::vector<std::pair<std::string, std::string>> declares;
  int language_version = 0;  // hundredths; 0: not given
  bool output_to_file = true;
  std::string output_name;
  char file_type = 'N';
  bool greyscale = false, output_alpha = false;
  int bits = 8;
  int compression = 0;
  TransferCurve file_curve = TransferCurve::srgb();
  DitherMethod dither = DitherMethod::none;
  size_t most_picture_bytes = size_t{128} << 20;  // in memory; larger pictures wait on the disk

  // what to render
  bool parse_only = false;
  bool compare_methods = false;  // durer compare-methods
  RenderOptions render;
  bool clock_given = false;
  double clock = 0;
  Animation animation;
  bool clockless_animation = false;
  bool continue_trace = false;
  int bounding_threshold = 3;
  bool remove_bounds = true, split_unions = false;

  // telling the user
  bool verbose = true;
  std::array<StreamOptions, kStreamCount> streams;
  std::string all_file;
  bool append_files = false;
  std::string stats_file;
  std::string create_ini;
  double preview_interval = 0;  // seconds; 0: none

  // safety
  bool allow_shell = false;
  std::vector<std::string> writable_folders;
  double max_loop_turns = 0, max_array_elements = 0, max_objects = 0;  // 0: the parser's own limit
  int max_macro_depth = 0;
  double max_memory = 0;                              // megabytes; 0: what the machine has
  std::array<ShellCommand, static_cast<int>(ShellEvent::count)> commands;
};

// Throws OptionError. The picture's window is left whole: see resolve_window.
Options resolve_options(const OptionValues& values);

// The rectangle of Start/End_Row/Column (spec/language.md 34); throws OptionError for one that
// begins or ends outside the picture. Empty windows are allowed.
PixelWindow resolve_window(const OptionValues& values, int width, int height);

}  // namespace durer
