#include "cli/options.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/output_name.h"

namespace durer {
namespace {

int available_processors() {
  const long count = sysconf(_SC_NPROCESSORS_ONLN);
  return count >= 2 ? static_cast<int>(count) : 1;
}

// Declare=name=value. A string keeps its quotes: the parser tells it from a number by them.
std::pair<std::string, std::string> declaration(const std::string& text) {
  const size_t equals = text.find('=');
  return {text.substr(0, equals), text.substr(equals + 1)};
}

DitherMethod dither_method(const OptionValues& values) {
  if (!values.toggle(Option::dither, false)) return DitherMethod::none;
  const std::string name = values.text(Option::dither_method, "FS");
  if (name == "B2") return DitherMethod::bayer2;
  if (name == "B3") return DitherMethod::bayer3;
  if (name == "B4") return DitherMethod::bayer4;
  if (name == "D1") return DitherMethod::diffusion1;
  if (name == "D2") return DitherMethod::diffusion2;
  return DitherMethod::floyd_steinberg;
}

void resolve_files(const OptionValues& values, Options& options) {
  options.input_file = values.text(Option::input_file_name);
  options.include_header = values.text(Option::include_header);
  options.library_paths = values.list(Option::library_path);
  for (const std::string& text : values.list(Option::declare)) {
    options.declares.push_back(declaration(text));
  }
  if (values.is_set(Option::version)) {
    const double version = std::clamp(values.number(Option::version, 0), 1.0, 100.0);
    options.language_version = static_cast<int>(std::lround(version * 100));
  }
  options.output_to_file = values.toggle(Option::output_to_file, true) &&
                           !values.toggle(Option::real_time_raytracing, false);
  options.output_name = values.text(Option::output_file_name);
  options.file_type = values.text(Option::output_file_type, "N")[0];
  options.greyscale = values.toggle(Option::grayscale_output, false);
  options.output_alpha = values.toggle(Option::output_alpha, false);
  options.bits = std::clamp(values.integer(Option::bits_per_color, 8), 5, 16);
  options.compression = std::clamp(values.integer(Option::compression, 0), 0, 255);
  if (values.is_set(Option::file_gamma) && values.text(Option::file_gamma) != "srgb") {
    options.file_curve = TransferCurve::power(values.number(Option::file_gamma, 1));
  }
  options.dither = dither_method(values);
  options.most_picture_bytes =
      static_cast<size_t>(std::max(values.integer(Option::max_image_buffer_memory, 128), 0)) << 20;
  if (options.greyscale && options.file_type != 'N' && options.file_type != 'P') {
    throw OptionError("grey pictures can be written as PNG (N) and PPM (P) only");
  }
  if (is_standard_stream(options.output_name) &&
      (options.file_type == 'J' || options.file_type == 'E')) {
    throw OptionError("JPEG and OpenEXR pictures cannot be written to standard output");
  }
}

void resolve_antialiasing(const OptionValues& values, RenderOptions& render) {
  const std::string name = values.text(Option::supersampling);
  const int method = std::clamp(values.integer(Option::sampling_method, 1), 0, 2);
  if (!name.empty()) {
    if (name == "none") {
      render.supersampling = Supersampling::none;
    } else if (name == "method1") {
      render.supersampling = Supersampling::method1;
    } else if (name == "method2" || name == "adaptive") {
      render.supersampling = Supersampling::method2;
    } else if (name == "grid") {
      render.supersampling = Supersampling::grid;
    } else if (name == "jitter") {
      render.supersampling = Supersampling::jitter;
    } else {
      throw OptionError("Supersampling is none, grid, jitter, adaptive (as method2), method1 or " +
                        ("method2, not '" + name + "'"));
    }
  } else if (values.toggle(Option::antialias, false) && method != 0) {
    render.supersampling = method == 2 ? Supersampling::method2 : Supersampling::method1;
  }
  render.grid_samples = std::clamp(values.integer(Option::supersampling_grid, 3), 1, 64);
  // POV-Ray keeps these in single precision and computes with them in double.
  const auto single = [&](Option option, double otherwise) {
    return static_cast<double>(static_cast<float>(values.number(option, otherwise)));
  };
  render.antialias_threshold = std::clamp(single(Option::antialias_threshold, 0.3), 0.0, 1.0);
  render.antialias_depth = std::clamp(values.integer(Option::antialias_depth, 3), 1, 9);
  render.antialias_gamma = single(Option::antialias_gamma, 2.5);
  const bool jitter = values.toggle(Option::jitter, true);
  render.jitter_amount = jitter ? std::clamp(single(Option::jitter_amount, 1), 0.0, 1.0) : 0;
}

void resolve_render(const OptionValues& values, RenderOptions& render) {
  render.width = values.integer(Option::width, 160);
  render.height = values.integer(Option::height, 120);
  if (render.width < 1 || render.height < 1) {
    throw OptionError("a picture of " + std::to_string(render.width) + " by " +
                      std::to_string(render.height) + " pixels cannot be rendered");
  }
  // 2^31 pixels of 16 bytes are 32 GB: more is a slip.
  if (static_cast<double>(render.width) * render.height > 2147483647.0) {
    throw OptionError("a picture of " + std::to_string(render.width) + " by " +
                      std::to_string(render.height) + " pixels is too large");
  }
  render.window = resolve_window(values, render.width, render.height);
  render.threads =
      std::clamp(values.integer(Option::work_threads, available_processors()), 1, 512);
  render.block_size = values.integer(Option::render_block_size, 32);
  if (render.block_size < 4) throw OptionError("blocks are at least 4 pixels wide");
  render.quality = std::clamp(values.integer(Option::quality, 9), 0, 9);
  render.output_alpha = values.toggle(Option::output_alpha, false);
  const std::string integrator = values.text(Option::integrator, "whitted");
  if (integrator == "raycast") {
    render.integrator = IntegratorKind::raycast;
  } else if (integrator != "whitted") {
    throw OptionError("the integrators are whitted and raycast, not '" + integrator + "'");
  }
  resolve_antialiasing(values, render);
}

// What reads as "true", also "one.txt", means the stream's usual file name, as in POV-Ray; all else, also
// "off", is a name.
std::string stream_file(const OptionValues& values, Option id, const char* usual) {
  if (!values.is_set(id)) return "";
  const std::string name = values.text(id);
  if (read_toggle(name)) return usual;
  if (name.find('/') != std::string::npos) {
    throw OptionError(std::string(option_entry(id).ini_name) +
                      " must be a bare file name (it is placed beside the picture), not '" + name +
                      "'");
  }
  return name;
}

void resolve_streams(const OptionValues& values, Options& options) {
  struct Row {
    Stream stream;
    Option console, file;
    const char* usual;
  };
  constexpr Row rows[] = {
      {Stream::debug, Option::debug_console, Option::debug_file, "debug.out"},
      {Stream::fatal, Option::fatal_console, Option::fatal_file, "fatal.out"},
      {Stream::render, Option::render_console, Option::render_file, "render.out"},
      {Stream::statistic, Option::statistic_console, Option::statistic_file, "stats.out"},
      {Stream::warning, Option::warning_console, Option::warning_file, "warning.out"},
  };
  for (const Row& row : rows) {
    StreamOptions& stream = options.streams[static_cast<size_t>(row.stream)];
    stream.console = values.toggle(row.console, true);
    stream.file = stream_file(values, row.file, row.usual);
    // All_Console, where given, overrides the five others.
    if (values.is_set(Option::all_console)) stream.console = values.toggle(Option::all_console, true);
  }
  options.all_file = stream_file(values, Option::all_file, "alltext.out");
  options.append_files = values.toggle(Option::append_file, false);
  options.verbose = values.toggle(Option::verbose, true);
  options.stats_file = values.text(Option::stats_file);
  if (options.stats_file == "-" && options.output_to_file &&
      (options.output_name == "-" || options.output_name == "stdout")) {
    throw OptionError("the picture and the statistics cannot both be written to standard output");
  }
  options.create_ini = values.text(Option::create_ini);
  options.preview_interval = std::max(values.number(Option::preview_interval, 0), 0.0);
}

ShellCommand shell_command(const OptionValues& values, Option command, Option action) {
  const ReturnAction said = read_return_action(values.text(action, "I"));
  return {values.text(command), said.letter, said.is_negated};
}

void resolve_commands(const OptionValues& values, Options& options) {
  options.commands = {
      shell_command(values, Option::pre_scene_command, Option::pre_scene_return),
      shell_command(values, Option::pre_frame_command, Option::pre_frame_return),
      shell_command(values, Option::post_frame_command, Option::post_frame_return),
      shell_command(values, Option::post_scene_command, Option::post_scene_return),
      shell_command(values, Option::user_abort_command, Option::user_abort_return),
      shell_command(values, Option::fatal_error_command, Option::fatal_error_return)};
  options.allow_shell = values.toggle(Option::allow_shell, false);
  options.writable_folders = values.list(Option::allow_write);
  options.max_loop_turns = values.number(Option::max_loop_turns, 0);
  options.max_array_elements = values.number(Option::max_array_elements, 0);
  options.max_objects = values.number(Option::max_objects, 0);
  options.max_macro_depth = std::clamp(values.integer(Option::max_macro_depth, 0), 0, 1'000'000);
  options.max_memory = values.number(Option::max_memory, 0);
}

// Row and column bounds are rounded to single precision first and then used in double.
int window_start(double value, int size) {
  const double v = static_cast<float>(value);
  if (v >= 0 && v < 1) return static_cast<int>(size * v);
  return static_cast<int>(std::clamp(v, -1e9, 1e9)) - 1;
}

int window_end(double value, int size) {
  const double v = static_cast<float>(value);
  if (v >= 0 && v <= 1) return static_cast<int>(size * v) - 1;
  return static_cast<int>(std::clamp(v, -1e9, 1e9) - 1);
}

}  // namespace

ReturnAction read_return_action(std::string_view text) {
  ReturnAction said;
  said.is_negated = !text.empty() && (text[0] == '-' || text[0] == '!');
  if (said.is_negated) text.remove_prefix(1);
  const char letter = text.empty() ? '?' : static_cast<char>(text[0] & ~0x20);
  said.is_known = std::string_view("ISAQUF").find(letter) != std::string_view::npos;
  if (said.is_known) said.letter = letter;
  return said;
}

PixelWindow resolve_window(const OptionValues& values, int width, int height) {
  const int left = window_start(values.number(Option::start_column, 1), width);
  const int top = window_start(values.number(Option::start_row, 1), height);
  const int right = window_end(values.number(Option::end_column, width), width);
  const int bottom = window_end(values.number(Option::end_row, height), height);
  if (left < 0 || left >= width || top < 0 || top >= height) {
    throw OptionError("the start column or row lies outside the picture");
  }
  // A picture of one pixel has its end at 1: 100 percent.
  if (right < 0 || right >= width || bottom < 0 || bottom >= height) {
    throw OptionError("the end column or row lies outside the picture");
  }
  return {left, top, std::max(right + 1, left), std::max(bottom + 1, top)};
}

Options resolve_options(const OptionValues& values) {
  Options options;
  resolve_files(values, options);
  resolve_render(values, options.render);
  resolve_streams(values, options);
  resolve_commands(values, options);
  options.parse_only = values.toggle(Option::parse_only, false);
  options.clock_given = values.is_set(Option::clock);
  options.clock = static_cast<float>(values.number(Option::clock, 0));
  options.animation = animation_from(values);
  options.clockless_animation = values.toggle(Option::clockless_animation, false);
  options.continue_trace = values.toggle(Option::continue_trace, false);
  // Without bounding no number of objects is enough.
  options.bounding_threshold = values.toggle(Option::bounding, true)
                                   ? values.integer(Option::bounding_threshold, 3)
                                   : std::numeric_limits<int>::max();
  options.remove_bounds = values.toggle(Option::remove_bounds, true);
  options.split_unions = values.toggle(Option::split_unions, false);
  return options;
}

}  // namespace durer
