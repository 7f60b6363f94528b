// The one table of everything that can be set: by INI keyword, by POV-Ray's +/- switch, by a long
// option. The readers, --help, Create_INI and the man page's test are all made from it.
// Source: spec/language.md 31; the switch grammar is spec/language.md 30.1.
#pragma once

#include <cstdint>
#include <string_view>

namespace durer {

enum class OptionKind : uint8_t {
  toggle,         // on/off
  integer,        // read by its decimal prefix
  number,         // floating point, read by its prefix
  subset_frame,   // +SF: an integer; +SF0.x and INI: a number
  text,           // string; several INI values accumulate only for `list`
  list,           // strings, accumulating
  file_type,      // a letter, in switch form followed by bits per colour or g
  dither_method,  // B2 B3 B4 D1 D2 FS
  gamma,          // number or srgb
  include_ini,    // reads another INI file in place
  obsolete,       // INI keyword of older versions: a message, no effect
};

enum class OptionGroup : uint8_t {
  picture,
  files,
  antialiasing,
  quality,
  part,
  animation,
  speed,
  messages,
  safety,
  display,
  commands,
};

// In the order in which POV-Ray's Create_INI writes them; Dürer's own ones follow.
enum class Option : uint8_t {
  all_console,
  all_file,
  antialias_depth,
  antialias,
  antialias_threshold,
  antialias_gamma,
  append_file,
  bits_per_color,
  bounding,
  bounding_method,
  bounding_threshold,
  bsp_base_access_cost,
  bsp_child_access_cost,
  bsp_isect_cost,
  bsp_max_depth,
  bsp_miss_chance,
  clock,
  clockless_animation,
  compression,
  continue_trace,
  create_ini,
  cyclic_animation,
  debug_console,
  debug_file,
  declare,
  display,
  display_gamma,
  dither,
  dither_method,
  draw_vistas,
  end_column,
  end_row,
  fatal_console,
  fatal_error_command,
  fatal_error_return,
  fatal_file,
  field_render,
  file_gamma,
  final_clock,
  final_frame,
  frame_step,
  grayscale_output,
  height,
  high_reproducibility,
  initial_clock,
  initial_frame,
  input_file_name,
  include_header,
  include_ini,
  jitter_amount,
  jitter,
  library_path,
  light_buffer,
  max_image_buffer_memory,
  odd_field,
  output_alpha,
  output_file_name,
  output_file_type,
  output_to_file,
  palette,
  pause_when_done,
  post_frame_command,
  post_frame_return,
  post_scene_command,
  post_scene_return,
  preview_end_size,
  preview_start_size,
  pre_frame_command,
  pre_frame_return,
  pre_scene_command,
  pre_scene_return,
  quality,
  radiosity_file_name,
  radiosity_from_file,
  radiosity_to_file,
  radiosity_vain_pretrace,
  real_time_raytracing,
  remove_bounds,
  render_block_size,
  render_block_step,
  render_console,
  render_file,
  render_pattern,
  sampling_method,
  split_unions,
  start_column,
  start_row,
  statistic_console,
  statistic_file,
  subset_end_frame,
  subset_start_frame,
  test_abort_count,
  test_abort,
  user_abort_command,
  user_abort_return,
  verbose,
  version,
  video_mode,
  vista_buffer,
  warning_console,
  warning_file,
  warning_level,
  width,
  work_threads,
  // Obsolete keywords.
  buffer_output,
  buffer_size,
  create_histogram,
  histogram_name,
  histogram_grid_size,
  histogram_type,
  // Dürer's own.
  allow_shell,
  allow_write,
  integrator,
  max_array_elements,
  max_macro_depth,
  max_memory,
  max_objects,
  max_loop_turns,
  parse_only,
  preview_interval,
  stats_file,
  supersampling,
  supersampling_grid,
  count,
};

inline constexpr int kOptionCount = static_cast<int>(Option::count);

struct OptionEntry {
  Option id;
  const char* ini_name;
  const char* switches;   // POV-Ray's, separated by blanks; a final 0 belongs to the value ("A0")
  const char* long_name;  // without --; empty: none
  OptionKind kind;
  Option sign;            // what the switch's + or - sets as well; Option::count: nothing
  const char* value_name;  // for --help
  OptionGroup group;
  const char* help;
  // What to tell a user who sets it where Dürer has nothing to obey; empty: it is obeyed.
  const char* note;
};

const OptionEntry& option_entry(Option id);
const OptionEntry& option_entry(int index);
// Null: no such name. INI names are compared without regard to letter case.
const OptionEntry* find_ini_option(std::string_view name);
const OptionEntry* find_long_option(std::string_view name);
// The entry that a switch such as "A0.3" (without its sign) means, and the length of the switch
// name in it. Null: there is none.
const OptionEntry* find_switch(std::string_view word, size_t& name_length);

bool equal_ignoring_case(std::string_view a, std::string_view b);

}  // namespace durer
