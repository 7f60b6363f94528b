// The settings that were made, by table entry, before anybody looks at what they mean together.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cli/option_table.h"

namespace durer {

class OptionValues {
 public:
  bool is_set(Option id) const { return value(id).set; }
  bool toggle(Option id, bool otherwise) const;
  int integer(Option id, int otherwise) const;
  double number(Option id, double otherwise) const;
  std::string text(Option id, const std::string& otherwise = "") const;
  const std::vector<std::string>& list(Option id) const { return value(id).list; }

  void set_toggle(Option id, bool on);
  void set_integer(Option id, int n);
  // A list that has the element already keeps it where it is.
  void add_to_list(Option id, const std::string& element);
  // Reads a value as its kind demands. False: it is no such value.
  bool set_from_text(Option id, std::string_view text);
  // Switch form of Output_File_Type: a letter, then nothing, bits per colour, or g.
  bool set_file_type_from_switch(std::string_view text);

  // A single value as Create_INI writes it.
  std::string written(Option id) const;
  // Name=value lines in the table's order, as POV-Ray's Create_INI writes them.
  std::string to_ini() const;

 private:
  struct Value {
    bool set = false;
    bool toggle = false;
    int integer = 0;
    double number = 0;
    std::string text;
    std::vector<std::string> list;
  };
  Value& value(Option id) { return values_[static_cast<size_t>(id)]; }
  const Value& value(Option id) const { return values_[static_cast<size_t>(id)]; }

  std::array<Value, kOptionCount> values_;
};

// "o", "true", "1x" are true: the comparison stops at the shorter one's end (spec/language.md 30.1).
bool read_toggle(std::string_view text);
bool read_integer(std::string_view text, int& n);     // decimal prefix
bool read_number(std::string_view text, double& number);  // floating-point prefix
// Whether all of the text says what a value of this kind is read as: not 12abc, 2GB or maybe.
bool is_whole_value(OptionKind kind, std::string_view text);
// File types by letter; grey: whether it can be stored as a grey picture.
bool is_file_type(char letter);

}  // namespace durer
