#include "cli/setting_notes.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "cli/output_name.h"
#include "parser/keyword.h"

namespace durer {
namespace {

// The ranges that resolve_options() keeps to.
struct Range {
  Option option;
  double least, most;
};
constexpr Range kRanges[] = {
    {Option::antialias_depth, 1, 9},
    {Option::antialias_threshold, 0, 1},
    {Option::bits_per_color, 5, 16},
    {Option::compression, 0, 255},
    {Option::jitter_amount, 0, 1},
    {Option::max_image_buffer_memory, 0, 1e9},
    {Option::preview_interval, 0, 1e9},
    // POV-Ray's manual has levels 10 and 11; they are the same as 9.
    {Option::quality, 0, 11},
    {Option::sampling_method, 0, 2},
    {Option::supersampling_grid, 1, 64},
    {Option::work_threads, 1, 512},
};

double number_of(const OptionValues& values, Option option) {
  return option_entry(option).kind == OptionKind::integer ? values.integer(option, 0)
                                                          : values.number(option, 0);
}

std::string name_of(Option option) {
  return option_entry(option).ini_name;
}

bool is_one_of(char letter, const char* letters) {
  return std::strchr(letters, letter) != nullptr;
}

void note_ranges(const OptionValues& values, std::vector<std::string>& notes) {
  for (const Range& range : kRanges) {
    if (!values.is_set(range.option)) continue;
    const double number = number_of(values, range.option);
    if (number >= range.least && number <= range.most) continue;
    const int used = static_cast<int>(std::clamp(number, range.least, range.most));
    notes.push_back(name_of(range.option) + ": " + values.written(range.option) +
                    " is out of range and taken as " + std::to_string(used));
  }
}

bool is_reserved_word(const std::string& word) {
  for (int k = 0; k < kKeywordCount; ++k) {
    if (word == spelling(static_cast<Keyword>(k))) return true;
  }
  return false;
}

bool is_identifier(const std::string& word) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto is_part = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  return is_letter(word[0]) && std::all_of(word.begin(), word.end(), is_part);
}

// Declare=name=value as POV-Ray takes it: what cannot be a name is passed over, the first of two
// values stays, and a value is a string in quotes or the number that it begins with, else 0.
void note_declarations(const Options& options, std::vector<std::string>& notes) {
  for (auto it = options.declares.begin(); it != options.declares.end(); ++it) {
    const auto& [name, value] = *it;
    const std::string setting = "Declare=" + name + "=" + value + ": ";
    if (is_reserved_word(name)) {
      notes.push_back(setting + "passed over: '" + name + "' is a word of the scene language");
    } else if (!is_identifier(name)) {
      notes.push_back(setting + "passed over: '" + name + "' cannot be a name");
    } else if (std::any_of(options.declares.begin(), it,
                           [&](const auto& before) { return before.first == it->first; })) {
      notes.push_back(setting + "passed over: '" + name + "' is declared already");
    } else if (value.front() != '"' && !is_whole_value(OptionKind::number, value)) {
      double number = 0;
      if (!read_number(value, number)) number = 0;
      char text[64];
      std::snprintf(text, sizeof text, "%g", number);
      notes.push_back(setting + "read as the number " + text + " (a string: --declare '" + name +
                      "=\"" + value + "\"')");
    }
  }
}

// What the chosen file type cannot hold.
void note_file_type(const Options& options, std::vector<std::string>& notes) {
  if (!options.output_to_file || options.parse_only) return;
  const char type = options.file_type;
  const std::string suffix = std::string("files of the type ") + extension_of(type);
  if (options.output_alpha && is_one_of(type, "JPH")) {
    notes.push_back(name_of(Option::output_alpha) + ": " + suffix + " hold no transparency");
  }
  if (options.bits != 8 && is_one_of(type, "TCJBEH")) {
    notes.push_back(name_of(Option::bits_per_color) + ": " + suffix +
                    " have a number of bits of their own");
  }
  if (options.dither != DitherMethod::none && is_one_of(type, "JE")) {
    notes.push_back(name_of(Option::dither) + ": " + suffix + " are not dithered");
  }
  if (options.compression > 0 && !is_one_of(type, "NJ")) {
    notes.push_back(name_of(Option::compression) + ": only PNG and JPEG files have a level");
  }
  // +Opicture.jpg: the name does not choose the type, as in POV-Ray.
  const std::string file = file_part_of(options.output_name);
  const size_t dot = file.find_last_of('.');
  if (dot == std::string::npos || is_standard_stream(options.output_name)) return;
  for (const char* known :
       {"png", "jpg", "jpeg", "tga", "ppm", "bmp", "exr", "hdr", "tif", "tiff"}) {
    const std::string extension = file.substr(dot + 1);
    if (extension == extension_of(type) || !equal_ignoring_case(extension, known)) continue;
    notes.push_back(name_of(Option::output_file_name) + ": the name does not choose the type; '" +
                    file + "' gets the ending ." + extension_of(type) + " (--type " + known +
                    " makes the other file)");
  }
}

void note_antialiasing(const OptionValues& values, const Options& options,
                       std::vector<std::string>& notes) {
  const Supersampling method = options.render.supersampling;
  if (!values.is_set(Option::antialias) && !values.is_set(Option::supersampling) &&
      !options.compare_methods) {
    for (const Option option :
         {Option::antialias_depth, Option::antialias_gamma, Option::sampling_method}) {
      if (!values.is_set(option)) continue;
      notes.push_back(name_of(option) +
                      ": without effect, as antialiasing is off (+A turns it on)");
    }
  }
  if (values.is_set(Option::supersampling_grid) && method != Supersampling::grid &&
      method != Supersampling::jitter && !options.compare_methods) {
    notes.push_back(name_of(Option::supersampling_grid) +
                    ": without effect but with --supersampling grid or jitter");
  }
}

void note_animation(const OptionValues& values, const Options& options,
                    std::vector<std::string>& notes) {
  if (options.animation.on && options.clock_given) {
    notes.push_back(name_of(Option::clock) +
                    ": without effect in an animation, whose frames have "
                    "clocks of their own");
  }
  if (values.is_set(Option::initial_frame) || values.is_set(Option::final_frame)) return;
  for (const Option option :
       {Option::initial_clock, Option::final_clock, Option::frame_step, Option::cyclic_animation,
        Option::subset_start_frame, Option::subset_end_frame}) {
    if (!values.is_set(option)) continue;
    if (option == Option::cyclic_animation && !values.toggle(option, false)) continue;
    notes.push_back(name_of(option) +
                    ": without effect on a single picture (+KFFN makes N frames)");
  }
}

void note_return_actions(const OptionValues& values, std::vector<std::string>& notes) {
  for (const Option option :
       {Option::pre_scene_return, Option::pre_frame_return, Option::post_frame_return,
        Option::post_scene_return, Option::user_abort_return, Option::fatal_error_return}) {
    if (!values.is_set(option) || read_return_action(values.text(option)).is_known) continue;
    notes.push_back(name_of(option) + ": '" + values.text(option) +
                    "' is none of I S A Q U F and counts as I, ignore");
  }
}

void note_comparison(const OptionValues& values, const Options& options,
                     std::vector<std::string>& notes) {
  if (!options.compare_methods) return;
  for (const Option option :
       {Option::integrator, Option::supersampling, Option::continue_trace, Option::preview_interval,
        Option::start_column, Option::start_row, Option::end_column, Option::end_row}) {
    if (!values.is_set(option)) continue;
    if (option == Option::continue_trace && !options.continue_trace) continue;
    notes.push_back(name_of(option) +
                    ": without effect on compare-methods, which renders the whole "
                    "picture by every method");
  }
}

}  // namespace

std::vector<std::string> setting_notes(const OptionValues& values, const Options& options) {
  std::vector<std::string> notes;
  note_ranges(values, notes);
  note_declarations(options, notes);
  note_file_type(options, notes);
  note_antialiasing(values, options, notes);
  note_animation(values, options, notes);
  note_return_actions(values, notes);
  note_comparison(values, options, notes);
  return notes;
}

}  // namespace durer
