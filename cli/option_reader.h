// Reads settings from the command line and from INI files, in POV-Ray's grammar (spec/language.md
// 29 and 30) and with GNU-style long options beside it.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/option_values.h"

namespace durer {

// A setting that cannot be read. what() names the place and says what was expected.
class OptionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class OptionReader {
 public:
  explicit OptionReader(OptionValues& values) : values_(values) {}

  // The main INI file: the first that exists of $POVINI, ./povray.ini, ~/.povray/3.7/povray.ini,
  // /etc/povray/3.7/povray.ini, ~/.povrayrc.
  void read_main_ini();
  // Command-line arguments, left to right.
  void read_arguments(const std::vector<std::string>& arguments);
  // $POVINC, then the folders in which Debian installs POV-Ray's include files.
  void add_library_paths_of_the_system();
  // file[.ini][section]
  void read_ini(const std::string& name_with_section);

  // One line each: what was understood in another way than its author may think.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Text;

  // One +switch, Name=value or plain word, from a command-line argument or a line of an INI file.
  void read_item(Text& text);
  void read_switch(Text& text);
  void read_named(const OptionEntry& entry, Text& text);
  void read_plain_word(Text& text);
  void read_long_option(const std::vector<std::string>& arguments, size_t& index);
  void read_ini_file(const std::string& path, const std::string& section);
  void read_ini_line(Text& text);
  void set(const OptionEntry& entry, std::string_view value, const Text& text);
  void note_if_without_effect(const OptionEntry& entry);
  std::string find_ini(const std::string& name) const;

  OptionValues& values_;
  std::vector<std::string> notes_;
  int ini_depth_ = 0;
  bool system_settings_ = false;  // reading the main INI file: its settings are nobody's wish
};

}  // namespace durer
