#include "cli/help.h"

#include "cli/option_table.h"

namespace durer {
namespace {

struct GroupTitle {
  OptionGroup group;
  const char* title;
};
constexpr GroupTitle kGroups[] = {
    {OptionGroup::picture, "Picture"},
    {OptionGroup::files, "Files"},
    {OptionGroup::antialiasing, "Antialiasing"},
    {OptionGroup::quality, "Light"},
    {OptionGroup::part, "Part of the picture"},
    {OptionGroup::animation, "Animation"},
    {OptionGroup::speed, "Speed"},
    {OptionGroup::messages, "Messages"},
    {OptionGroup::safety, "Safety"},
    {OptionGroup::commands, "Commands (only with --allow-shell)"},
    {OptionGroup::display, "Display"},
};

// Explanations begin here; longer spellings get a line of their own.
constexpr size_t kHelpColumn = 36, kColumns = 98;

std::string wrapped(const std::string& text) {
  std::string out;
  size_t column = kHelpColumn;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find(' ', begin), text.size());
    const size_t length = end - begin;
    if (column + length + 1 > kColumns) {
      out += "\n" + std::string(kHelpColumn, ' ');
      column = kHelpColumn;
    } else if (begin > 0) {
      out += " ";
      ++column;
    }
    out += text.substr(begin, length);
    column += length;
    begin = end + 1;
  }
  return out;
}

}  // namespace

std::string option_spelling(const OptionEntry& entry) {
  const bool toggle = entry.kind == OptionKind::toggle;
  std::string out;
  std::string names = entry.switches;
  names.resize(std::min(names.find(' '), names.size()));
  if (!names.empty()) {
    // The final 0 of A0 is part of the value name 0.N.
    if (names.back() == '0') names.pop_back();
    out = (toggle ? "+" + names + " -" + names : "+" + names + entry.value_name);
  }
  if (*entry.long_name) {
    if (!out.empty()) out += ", ";
    out += std::string("--") + entry.long_name;
    if (!toggle) out += std::string(" ") + entry.value_name;
  }
  if (out.empty()) out = std::string(entry.ini_name) + "=" + (toggle ? "on" : entry.value_name);
  return out;
}

std::string help_text() {
  std::string out =
      "durer " DURER_VERSION
      ": renders scenes of POV-Ray's language.\n"
      "\n"
      "  durer scene.pov                        a picture in povray.ini's size (Debian: 800 x 600)\n"
      "  durer scene.pov +W1920 +H1080 +A0.1    larger, antialiased\n"
      "  durer scene.pov -O- > picture.png      to standard output\n"
      "  durer --parse-only scene.pov           only look for mistakes\n"
      "  durer compare-methods scene.pov        every method side by side: scene-methods.png\n"
      "  durer scene.ini[final]                 settings from a section of an INI file\n"
      "\n"
      "Settings come from povray.ini ($POVINI, ./povray.ini, ~/.povray/3.7/povray.ini,\n"
      "/etc/povray/3.7/povray.ini, ~/.povrayrc: the first that exists), then from the command line, left\n"
      "to right: POV-Ray's switches (+ turns on, - turns off; the value directly behind the name), long\n"
      "options (--no-NAME turns off), or Name=value as in INI files. What has no effect is said in a note;\n"
      "`man durer` lists those switches, too.\n";
  for (const GroupTitle& group : kGroups) {
    out += std::string("\n") + group.title + ":\n";
    for (int i = 0; i < kOptionCount; ++i) {
      const OptionEntry& entry = option_entry(i);
      if (entry.group != group.group || entry.kind == OptionKind::obsolete) continue;
      // What has no effect is listed in the man page only.
      if (*entry.note) continue;
      std::string line = "  " + option_spelling(entry);
      line += line.size() + 2 > kHelpColumn ? "\n" + std::string(kHelpColumn, ' ')
                                            : std::string(kHelpColumn - line.size(), ' ');
      out += line + wrapped(entry.help) + "\n";
    }
  }
  out +=
      "\n"
      "Other:\n"
      "  --help, -h, -?                    this text\n"
      "  --version                         the version\n"
      "\n"
      "Exit status: 0 success, 1 an error in settings, scene or files, 2 stopped by Ctrl-C,\n"
      "3 the scene needs something that is not supported yet. `man durer` tells more.\n";
  return out;
}

std::string version_text() {
  return "durer " DURER_VERSION
         "\nReads the scene language of POV-Ray 3.7. MIT licence; not connected with the POV-Ray "
         "team.\n";
}

}  // namespace durer
