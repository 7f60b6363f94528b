#include "cli/option_values.h"

#include <algorithm>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace durer {
namespace {

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = upper(c);
  return result;
}

}  // namespace

bool read_toggle(std::string_view text) {
  if (text.empty()) return true;
  for (const char* word : {"on", "true", "yes", "1"}) {
    const size_t length = std::min(text.size(), std::strlen(word));
    if (equal_ignoring_case(text.substr(0, length), {word, length})) return true;
  }
  return false;
}

bool read_integer(std::string_view text, int& n) {
  const std::string copy(text);
  char* end = nullptr;
  const long value = std::strtol(copy.c_str(), &end, 10);
  if (end == copy.c_str()) return false;
  n = static_cast<int>(std::clamp(value, static_cast<long>(INT_MIN), static_cast<long>(INT_MAX)));
  return true;
}

bool read_number(std::string_view text, double& number) {
  const std::string copy(text);
  char* end = nullptr;
  number = std::strtod(copy.c_str(), &end);
  return end != copy.c_str();
}

bool is_whole_value(OptionKind kind, std::string_view text) {
  // Blanks behind a value may belong to it in INI files, and say nothing.
  text = text.substr(0, text.find_last_not_of(" \t") + 1);
  const std::string copy(text);
  char* end = nullptr;
  switch (kind) {
    case OptionKind::toggle:
      for (const char* word : {"on", "true", "yes", "1", "off", "false", "no", "0"}) {
        if (equal_ignoring_case(text, word)) return true;
      }
      return false;
    case OptionKind::integer:
      std::strtol(copy.c_str(), &end, 10);
      break;
    case OptionKind::number:
    case OptionKind::subset_frame:
      std::strtod(copy.c_str(), &end);
      break;
    default:
      return true;
  }
  return end != copy.c_str() && *end == 0;
}

bool is_file_type(char letter) { return letter != 0 && std::strchr("NTCJPBEHF", upper(letter)); }

bool OptionValues::toggle(Option id, bool otherwise) const {
  return is_set(id) ? value(id).toggle : otherwise;
}
int OptionValues::integer(Option id, int otherwise) const {
  return is_set(id) ? value(id).integer : otherwise;
}
double OptionValues::number(Option id, double otherwise) const {
  return is_set(id) ? value(id).number : otherwise;
}
std::string OptionValues::text(Option id, const std::string& otherwise) const {
  return is_set(id) ? value(id).text : otherwise;
}

void OptionValues::set_toggle(Option id, bool on) {
  value(id).set = true;
  value(id).toggle = on;
}

void OptionValues::set_integer(Option id, int n) {
  value(id).set = true;
  value(id).integer = n;
}

void OptionValues::add_to_list(Option id, const std::string& element) {
  Value& entry = value(id);
  entry.set = true;
  if (std::find(entry.list.begin(), entry.list.end(), element) == entry.list.end()) {
    entry.list.push_back(element);
  }
}

bool OptionValues::set_from_text(Option id, std::string_view text) {
  Value& entry = value(id);
  Value read;
  read.set = true;
  switch (option_entry(id).kind) {
    case OptionKind::toggle:
      read.toggle = read_toggle(text);
      break;
    case OptionKind::integer:
      if (!read_integer(text, read.integer)) return false;
      break;
    case OptionKind::number:
    case OptionKind::subset_frame:
      if (!read_number(text, read.number)) return false;
      break;
    case OptionKind::text:
      read.text = text;
      break;
    case OptionKind::list:
      add_to_list(id, std::string(text));
      return true;
    case OptionKind::file_type:
      if (text.empty() || !is_file_type(text[0])) return false;
      read.text = std::string(1, upper(text[0]));
      break;
    case OptionKind::dither_method:
      read.text = upper(text);
      if (read.text != "B2" && read.text != "B3" && read.text != "B4" && read.text != "D1" &&
          read.text != "D2" && read.text != "FS") {
        return false;
      }
      break;
    case OptionKind::gamma:
      // A gamma below 0.001 would be no curve any more.
      if (equal_ignoring_case(text, "srgb")) {
        read.text = "srgb";
      } else if (!read_number(text, read.number) || !(read.number >= 0.001)) {
        return false;
      }
      break;
    case OptionKind::include_ini:
    case OptionKind::obsolete:
      return true;
  }
  entry = read;
  return true;
}

bool OptionValues::set_file_type_from_switch(std::string_view text) {
  if (!set_from_text(Option::output_file_type, text.substr(0, 1))) return false;
  const std::string_view rest = text.substr(1);
  if (rest.empty()) return true;
  const char letter = value(Option::output_file_type).text[0];
  if (rest.size() == 1 && upper(rest[0]) == 'G') {
    set_toggle(Option::grayscale_output, true);
    return letter == 'N' || letter == 'P';
  }
  for (char c : rest) {
    if (c < '0' || c > '9') return false;
  }
  return set_from_text(Option::bits_per_color, rest);
}

std::string OptionValues::written(Option id) const {
  const OptionEntry& entry = option_entry(id);
  const Value& v = value(id);
  char number[64];
  switch (entry.kind) {
    case OptionKind::toggle:
      return v.toggle ? "On" : "Off";
    case OptionKind::integer:
      return std::to_string(v.integer);
    case OptionKind::number:
    case OptionKind::subset_frame:
      std::snprintf(number, sizeof number, "%g", v.number);
      return number;
    case OptionKind::gamma:
      std::snprintf(number, sizeof number, "%g", v.number);
      return v.text.empty() ? number : v.text;
    case OptionKind::text:
      return id == Option::video_mode ? v.text : "\"" + v.text + "\"";
    default:
      return v.text;
  }
}

std::string OptionValues::to_ini() const {
  std::string out;
  for (int i = 0; i < kOptionCount; ++i) {
    const OptionEntry& entry = option_entry(i);
    const Value& v = value(entry.id);
    if (!v.set) continue;
    const std::string name = std::string(entry.ini_name) + "=";
    switch (entry.kind) {
      case OptionKind::list:
        for (const std::string& element : v.list) {
          // A declared string is quoted itself.
          const bool has_string = element.find('"') != std::string::npos;
          const char* quote = entry.id != Option::declare ? "\"" : has_string ? "'" : "";
          out += name + quote + element + quote + "\n";
        }
        break;
      case OptionKind::include_ini:
      case OptionKind::obsolete:
        break;
      default:
        out += name + written(entry.id) + "\n";
        break;
    }
  }
  return out;
}

}  // namespace durer
