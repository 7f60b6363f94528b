#include "cli/option_reader.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "parser/edit_distance.h"

namespace durer {
namespace {

constexpr int kMostNestedIniFiles = 32;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
bool is_quote(char c) { return c == '"' || c == '\''; }
bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_file(const std::string& path) {
  struct stat status;
  return stat(path.c_str(), &status) == 0 && !S_ISDIR(status.st_mode);
}
bool is_folder(const std::string& path) {
  struct stat status;
  return stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool read_whole_file(const std::string& path, std::string& content) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) return false;
  char buffer[4096];
  size_t count;
  while ((count = std::fread(buffer, 1, sizeof buffer, file)) > 0) content.append(buffer, count);
  const bool good = !std::ferror(file);
  std::fclose(file);
  return good;
}

// name=value; POV-Ray passes over anything else.
bool is_declaration(std::string_view text) {
  const size_t equals = text.find('=');
  return equals != 0 && equals != std::string_view::npos && equals + 1 < text.size();
}

// "my scene.pov" is several items to POV-Ray, so that no scene with a blank in its name can be
// given without quotes inside of the shell's.
bool is_scene_with_blanks(const std::string& argument) {
  if (argument.size() < 4 || argument[0] == '+' || argument[0] == '-') return false;
  return argument.find_first_of(" \t") != std::string::npos &&
         equal_ignoring_case(std::string_view(argument).substr(argument.size() - 4), ".pov") &&
         is_file(argument);
}

}  // namespace

// An argument or a line while it is read.
struct OptionReader::Text {
  std::string_view all;
  size_t at = 0;
  std::string place;  // "command line" or "file:line"
  bool from_ini = false;
  // Nothing follows this line, or the next one begins at once with the name of a setting.
  bool setting_follows = true;

  bool at_end() const { return at >= all.size(); }
  char peek() const { return at_end() ? '\0' : all[at]; }
  void skip_blanks() {
    while (!at_end() && is_blank(all[at])) ++at;
  }
  // Up to one of `stops` or a blank.
  std::string_view word(const char* stops) {
    const size_t begin = at;
    while (!at_end() && !is_blank(all[at]) && !std::strchr(stops, all[at])) ++at;
    return all.substr(begin, at - begin);
  }
  // The name of a setting and = stand here.
  bool setting_begins() const {
    size_t end = at;
    while (end < all.size() && is_name_character(all[end])) ++end;
    while (end < all.size() && is_blank(all[end])) ++end;
    return end > at && end < all.size() && all[end] == '=';
  }
  // A quoted string's inside; the rest of the line if the quote is never closed.
  std::string_view quoted() {
    const char quote = all[at++];
    const size_t end = std::min(all.find(quote, at), all.size());
    const std::string_view inside = all.substr(at, end - at);
    at = std::min(end + 1, all.size());
    return inside;
  }
  [[noreturn]] void fail(const std::string& what) const { throw OptionError(place + ": " + what); }
};

void OptionReader::note_if_without_effect(const OptionEntry& entry) {
  if (*entry.note == 0 || system_settings_) return;
  const bool wanted = entry.kind != OptionKind::toggle || values_.toggle(entry.id, true);
  // Turning off what Dürer has not is obeyed.
  if (!wanted && entry.id != Option::bounding) return;
  const std::string note = std::string(entry.ini_name) + ": " + entry.note;
  if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
}

void OptionReader::set(const OptionEntry& entry, std::string_view value, const Text& text) {
  if (entry.kind == OptionKind::include_ini) {
    read_ini(std::string(value));
    return;
  }
  if (entry.id == Option::declare && !is_declaration(value)) {
    notes_.push_back(text.place + ": Declare=" + std::string(value) +
                     " is passed over: it lacks a name or a value, as in Declare=Count=3");
    return;
  }
  if (!values_.set_from_text(entry.id, value)) {
    text.fail(std::string(entry.ini_name) + " cannot be '" + std::string(value) + "'");
  }
  if (!is_whole_value(entry.kind, value)) {
    const std::string read = entry.kind != OptionKind::toggle ? values_.written(entry.id)
                             : values_.toggle(entry.id, false) ? "on"
                                                               : "off";
    notes_.push_back(text.place + ": " + entry.ini_name + ": '" + std::string(value) +
                     "' is read as " + read);
  }
  note_if_without_effect(entry);
}

void OptionReader::read_switch(Text& text) {
  const bool on = text.peek() == '+';
  const size_t begin = text.at++;
  std::string word(text.word("[]=;#\"'"));
  if (is_quote(text.peek())) {
    // +I"a b.pov": the quoted string directly after the name is its value.
    word += text.quoted();
  }
  const std::string whole(text.all.substr(begin, text.at - begin));
  size_t name_length = 0;
  const OptionEntry* entry = find_switch(word, name_length);
  if (!entry) {
    // +W 20: the name is there, its value is not.
    const OptionEntry* named = find_switch(word + "1", name_length);
    if (named && name_length == word.size()) {
      const std::string name = whole.substr(0, whole.size() - (whole.back() == '0' ? 1 : 0));
      text.fail("'" + whole + "' needs its value directly behind it: " + name + named->value_name);
    }
    const bool is_threshold =
        word.size() > 1 && (word[0] == 'A' || word[0] == 'a') && std::strchr(".123456789", word[1]);
    text.fail("there is no switch '" + whole + "' " +
              (is_threshold ? "(a threshold of antialiasing begins with 0: +A0.3)"
                            : "(durer --help lists them)"));
  }
  if (entry->kind == OptionKind::toggle) {
    values_.set_toggle(entry->id, on);
    note_if_without_effect(*entry);
    return;
  }
  // A final 0 of the name belongs to the value: +A0.3 is A0 and .3, read together as 0.3.
  const bool zero = word[name_length - 1] == '0';
  const std::string_view value = std::string_view(word).substr(name_length - (zero ? 1 : 0));
  if (entry->kind == OptionKind::file_type) {
    if (!values_.set_file_type_from_switch(value)) {
      text.fail("'" + whole + "' is no file type (N T C J P B E H F, with bits per colour or, for " +
                "N and P, g)");
    }
  } else if (entry->kind == OptionKind::subset_frame && !zero) {
    int frame = 0;
    if (!read_integer(value, frame)) text.fail("'" + whole + "' needs a frame number");
    set(*entry, std::to_string(frame), text);
  } else {
    set(*entry, value, text);
  }
  if (entry->sign != Option::count) values_.set_toggle(entry->sign, on);
}

void OptionReader::read_named(const OptionEntry& entry, Text& text) {
  if (entry.kind == OptionKind::obsolete && !text.from_ini) {
    text.fail(std::string(entry.ini_name) + " is not a setting of POV-Ray 3.7 any more");
  }
  // Commands are taken raw, to the end of the line or a comment outside quotes.
  if (entry.group == OptionGroup::commands && text.from_ini) {
    char quote = 0;
    const size_t begin = text.at;
    for (; !text.at_end(); ++text.at) {
      const char c = text.peek();
      if (quote) {
        if (c == quote) quote = 0;
      } else if (is_quote(c)) {
        quote = c;
      } else if (c == ';' || c == '#') {
        break;
      }
    }
    std::string_view command = text.all.substr(begin, text.at - begin);
    while (!command.empty() && is_blank(command.back())) command.remove_suffix(1);
    if (command.size() >= 2 && is_quote(command.front()) &&
        command.find(command.front(), 1) == command.size() - 1) {
      command = command.substr(1, command.size() - 2);
    }
    text.at = text.all.size();
    set(entry, command, text);
    return;
  }
  while (true) {
    if (is_quote(text.peek())) {
      set(entry, text.quoted(), text);
    } else {
      const size_t begin = text.at;
      // Commas separate several values in INI files only.
      std::string_view value = text.word(text.from_ini ? ",;#\"'" : ";#\"'");
      // Declare=foo="a b": the string is part of the value.
      if (entry.id == Option::declare && is_quote(text.peek()) && !text.from_ini) {
        text.fail("a declared string needs quotes around the whole, which shells take away: write "
                  "--declare 'name=\"text\"'");
      }
      if (text.from_ini && is_quote(text.peek())) {
        notes_.push_back(text.place + ": what begins with the quote behind '" + std::string(value) +
                         "' is not read; strings are declared on the command line");
        set(entry, value, text);
        break;
      }
      if (text.from_ini) {
        // A word and blanks, which are part of a string unless another setting follows; several
        // words are one value.
        const size_t end = text.at;
        text.skip_blanks();
        const char next = text.peek();
        const bool is_text = entry.kind == OptionKind::text || entry.kind == OptionKind::list;
        const bool keeps_blanks = text.at_end() && text.at > end && is_text && !text.setting_follows;
        const bool several = !text.at_end() && !std::strchr(",;#+-", next);
        if (keeps_blanks || several) {
          text.at = std::min({text.all.find(';', end), text.all.find('#', end), text.all.size()});
          value = text.all.substr(begin, text.at - begin);
          while (!is_text && !value.empty() && is_blank(value.back())) value.remove_suffix(1);
          // Of other values set() says what is read.
          if (is_text) {
            notes_.push_back(text.place + ": '" + std::string(value) +
                             "' is taken as one value; quote it if it is meant to be one");
          }
          set(entry, value, text);
          break;
        }
        text.at = end;
      }
      set(entry, value, text);
    }
    if (!text.from_ini) return;
    text.skip_blanks();
    if (text.peek() != ',') break;
    ++text.at;
    text.skip_blanks();
  }
  // Only one setting per line; POV-Ray passes over the rest.
  text.at = text.all.size();
}

void OptionReader::read_plain_word(Text& text) {
  std::string word;
  if (is_quote(text.peek())) {
    word = text.quoted();
  } else {
    const size_t begin = text.at;
    word = text.word("[;#\"'");
    // In an INI file several words are one name, but for settings and switches behind the first.
    const size_t end = text.at;
    text.skip_blanks();
    if (text.from_ini && text.at > end && !text.at_end() && !std::strchr(",;#+-[\"'", text.peek()) &&
        !text.setting_begins()) {
      text.at = std::min({text.all.find(';', end), text.all.find('#', end), text.all.size()});
      word = text.all.substr(begin, text.at - begin);
      word.resize(word.find_last_not_of(" \t") + 1);
    } else {
      text.at = end;
    }
  }
  const size_t length = word.size();
  if (length >= 4 && equal_ignoring_case(std::string_view(word).substr(length - 4), ".pov")) {
    values_.set_from_text(Option::input_file_name, word);
    return;
  }
  if (length > 0 && word.back() == '/') {
    values_.add_to_list(Option::library_path, word);
    return;
  }
  if (text.peek() == '[') {
    const size_t end = text.all.find(']', text.at);
    if (end == std::string_view::npos) {
      text.fail("the section's name in '" + std::string(text.all) + "' has no ']' at its end");
    }
    std::string_view section = text.all.substr(text.at + 1, end - text.at - 1);
    // povray reads no quotes here; as part of the name they would make the section be missed silently.
    if (section.size() >= 2 && is_quote(section.front()) && section.back() == section.front()) {
      section = section.substr(1, section.size() - 2);
    }
    word += "[" + std::string(section) + "]";
    text.at = end + 1;
  }
  if (word.empty()) text.fail("cannot read '" + std::string(text.all) + "'");
  const std::string file = word.substr(0, word.find('['));
  if (find_ini(file).empty()) {
    // A scene whose .pov was forgotten is a likelier slip than a missing INI file.
    const std::string hint = is_file(file + ".pov") ? "; is the scene " + file + ".pov meant?" : "";
    text.fail("'" + file + "' is taken for an INI file (it has no = and does not end in .pov), " +
              "and there is none of this name" + hint);
  }
  read_ini(word);
}

void OptionReader::read_item(Text& text) {
  if (text.peek() == '+' || text.peek() == '-') {
    read_switch(text);
    return;
  }
  // Name=value, with blanks around = in INI files.
  const size_t begin = text.at;
  while (!text.at_end() && is_name_character(text.peek())) ++text.at;
  const std::string_view name = text.all.substr(begin, text.at - begin);
  if (text.from_ini) text.skip_blanks();
  if (text.peek() == '=' && !name.empty()) {
    const OptionEntry* entry = find_ini_option(name);
    if (!entry) text.fail("there is no setting '" + std::string(name) + "'");
    ++text.at;
    if (text.from_ini) text.skip_blanks();
    read_named(*entry, text);
    return;
  }
  text.at = begin;
  read_plain_word(text);
}

// --type knows whole names; POV-Ray's Output_File_Type looks at the first letter only.
static std::string file_type_letter(const std::string& name) {
  static constexpr std::pair<const char*, const char*> kNames[] = {
      {"png", "N"},  {"tga", "T"},  {"tga-rle", "C"}, {"jpeg", "J"}, {"jpg", "J"}, {"ppm", "P"},
      {"bmp", "B"},  {"exr", "E"},  {"hdr", "H"},     {"tiff", "F"}, {"tif", "F"}};
  for (const auto& [word, letter] : kNames) {
    if (equal_ignoring_case(name, word)) return letter;
  }
  return name.size() == 1 && is_file_type(name[0]) ? name : "";
}

// The long option that was meant, for the error message; empty: none is near.
static std::string suggested_option(std::string_view name) {
  const int most = 2 * std::clamp(static_cast<int>(name.size()) / 3, 1, 3);
  int best = most + 1;
  std::string nearest;
  for (int i = 0; i < kOptionCount; ++i) {
    const char* known = option_entry(i).long_name;
    const int distance = edit_distance(name, known, most);
    if (*known && distance < best) best = distance, nearest = known;
  }
  return nearest.empty() ? "" : "; did you mean --" + nearest + "?";
}

void OptionReader::read_long_option(const std::vector<std::string>& arguments, size_t& index) {
  const std::string_view argument = std::string_view(arguments[index]).substr(2);
  const size_t equals = argument.find('=');
  const std::string_view name = argument.substr(0, equals);
  Text text{arguments[index], 0, "command line", false};
  bool on = true;
  const OptionEntry* entry = find_long_option(name);
  if (!entry && name.substr(0, 3) == "no-") {
    entry = find_long_option(name.substr(3));
    on = false;
    if (entry && entry->kind != OptionKind::toggle) entry = nullptr;
  }
  if (!entry) {
    const std::string suggestion = suggested_option(name);
    text.fail("there is no option '--" + std::string(name) + "'" +
              (suggestion.empty() ? " (durer --help lists them)" : suggestion));
  }
  std::string value;
  if (equals != std::string_view::npos) {
    value = argument.substr(equals + 1);
  } else if (entry->kind == OptionKind::toggle) {
    values_.set_toggle(entry->id, on);
    note_if_without_effect(*entry);
    return;
  } else if (index + 1 < arguments.size()) {
    value = arguments[++index];
  } else {
    text.fail("--" + std::string(name) + " needs a value: " + entry->value_name);
  }
  // POV-Ray reads the beginning of a word as a number; long options are ours and take whole words.
  const std::string refusal = "--" + std::string(name) + " cannot be '" + value + "': ";
  if (!is_whole_value(entry->kind, value)) {
    text.fail(refusal + (entry->kind == OptionKind::toggle    ? "on or off"
                         : entry->kind == OptionKind::integer ? "a whole number"
                                                              : "a number"));
  }
  if (entry->id == Option::declare && !is_declaration(value)) text.fail(refusal + "NAME=VALUE");
  if (entry->kind == OptionKind::file_type) {
    value = file_type_letter(value);
    if (value.empty()) text.fail(refusal + "png, tga, tga-rle, jpeg, ppm, bmp, exr, hdr or tiff");
  }
  set(*entry, value, text);
  if (entry->sign != Option::count) values_.set_toggle(entry->sign, true);
  // --supersampling grid 4
  const auto is_number = [](const std::string& word) {
    return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
  };
  if (entry->id == Option::supersampling && index + 1 < arguments.size() &&
      is_number(arguments[index + 1])) {
    values_.set_from_text(Option::supersampling_grid, arguments[++index]);
  }
}

void OptionReader::read_arguments(const std::vector<std::string>& arguments) {
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].size() > 2 && arguments[i].compare(0, 2, "--") == 0) {
      read_long_option(arguments, i);
      continue;
    }
    Text text{arguments[i], 0, "command line", false};
    if (arguments[i].empty()) text.fail("an empty argument");
    if (is_scene_with_blanks(arguments[i])) {
      values_.set_from_text(Option::input_file_name, arguments[i]);
      continue;
    }
    // One argument may hold several items, separated by blanks.
    for (text.skip_blanks(); !text.at_end(); text.skip_blanks()) {
      const size_t before = text.at;
      read_item(text);
      if (text.at == before || (!text.at_end() && !is_blank(text.peek()))) {
        text.fail("cannot read '" + std::string(text.all.substr(text.at)) + "'");
      }
    }
  }
}

void OptionReader::read_ini_line(Text& text) {
  for (text.skip_blanks(); !text.at_end(); text.skip_blanks()) {
    if (text.peek() == ';' || text.peek() == '#') return;
    const size_t before = text.at;
    read_item(text);
    if (text.at == before) text.fail("cannot read '" + std::string(text.all.substr(before)) + "'");
  }
}

void OptionReader::read_ini_file(const std::string& path, const std::string& section) {
  std::string content;
  if (!read_whole_file(path, content)) throw OptionError("cannot read the INI file '" + path + "'");
  if (++ini_depth_ > kMostNestedIniFiles) {
    throw OptionError(path + ": INI files include each other more than " +
                      std::to_string(kMostNestedIniFiles) + " deep");
  }
  bool active = true;
  int line_number = 0;
  for (size_t begin = 0; begin < content.size();) {
    // Lines end in \n, \r\n or \r.
    const size_t end = std::min(content.find_first_of("\r\n", begin), content.size());
    Text text{std::string_view(content).substr(begin, end - begin), 0, "", true};
    begin = end + (content.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    text.place = path + ":" + std::to_string(++line_number);
    const unsigned char next = begin < content.size() ? content[begin] : 0;
    text.setting_follows = end == content.size() || std::isalpha(next) != 0;
    text.skip_blanks();
    if (text.peek() == '[') {
      const size_t close = std::min(text.all.find(']'), text.all.size());
      const std::string_view name = text.all.substr(text.at + 1, close - text.at - 1);
      active = !section.empty() && equal_ignoring_case(name, section);
      // Settings may follow on the same line.
      text.at = std::min(close + 1, text.all.size());
    }
    if (active) read_ini_line(text);
  }
  --ini_depth_;
}

std::string OptionReader::find_ini(const std::string& name) const {
  // The name itself counts if it has an extension of at most 3 characters.
  const size_t slash = name.find_last_of('/');
  const size_t dot = name.find_last_of('.');
  const bool has_extension = dot != std::string::npos &&
                             (slash == std::string::npos || dot > slash) &&
                             name.size() - dot - 1 <= 3;
  std::vector<std::string> candidates;
  if (has_extension) candidates.push_back(name);
  candidates.push_back(name + ".ini");
  candidates.push_back(name + ".INI");
  for (const std::string& candidate : candidates) {
    if (is_file(candidate)) return candidate;
  }
  if (!name.empty() && name[0] == '/') return "";
  for (const std::string& folder : values_.list(Option::library_path)) {
    for (const std::string& candidate : candidates) {
      const std::string path = folder + "/" + candidate;
      if (is_file(path)) return path;
    }
  }
  return "";
}

void OptionReader::read_ini(const std::string& name_with_section) {
  const size_t bracket = name_with_section.find('[');
  const std::string name = name_with_section.substr(0, bracket);
  std::string section;
  if (bracket != std::string::npos) {
    section = name_with_section.substr(bracket + 1);
    section.resize(std::min(section.find(']'), section.size()));
  }
  const std::string path = find_ini(name);
  if (path.empty()) throw OptionError("there is no INI file '" + name + "'");
  read_ini_file(path, section);
}

void OptionReader::read_main_ini() {
  const std::string home = environment("HOME");
  std::vector<std::string> candidates;
  const std::string wanted = environment("POVINI");
  if (!wanted.empty()) {
    if (is_file(wanted)) {
      candidates.push_back(wanted);
    } else {
      notes_.push_back("POVINI: cannot open '" + wanted + "'");
    }
  }
  candidates.push_back("./povray.ini");
  if (!home.empty()) candidates.push_back(home + "/.povray/3.7/povray.ini");
  candidates.push_back("/etc/povray/3.7/povray.ini");
  if (!home.empty()) candidates.push_back(home + "/.povrayrc");
  for (const std::string& path : candidates) {
    if (!is_file(path)) continue;
    system_settings_ = true;
    read_ini_file(path, "");
    system_settings_ = false;
    return;
  }
}

void OptionReader::add_library_paths_of_the_system() {
  const std::string wanted = environment("POVINC");
  if (!wanted.empty()) values_.add_to_list(Option::library_path, wanted);
  // Where no povray.ini says so, Debian's include files are found nevertheless.
  for (const char* folder : {"/usr/share/povray-3.7/include", "/usr/share/povray/include",
                             "/usr/local/share/povray-3.7/include"}) {
    if (is_folder(folder)) values_.add_to_list(Option::library_path, folder);
  }
}

}  // namespace durer
