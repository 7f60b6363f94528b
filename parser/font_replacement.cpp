#include "parser/font_replacement.h"

#include <fontconfig/fontconfig.h>
#include <strings.h>

#include <algorithm>
#include <cctype>
#include <memory>

#include "tracer/system/shared_library.h"

namespace durer {
namespace {

struct Fontconfig {
  SharedLibrary library{DURER_FONTCONFIG_LIBRARY};
  DURER_IMPORT(FcInit);
  DURER_IMPORT(FcFini);
  DURER_IMPORT(FcPatternCreate);
  DURER_IMPORT(FcPatternDestroy);
  DURER_IMPORT(FcPatternAddString);
  DURER_IMPORT(FcPatternAddInteger);
  DURER_IMPORT(FcPatternAddBool);
  DURER_IMPORT(FcPatternGetString);
  DURER_IMPORT(FcObjectSetBuild);
  DURER_IMPORT(FcObjectSetDestroy);
  DURER_IMPORT(FcFontList);
  DURER_IMPORT(FcFontSetDestroy);
  DURER_IMPORT(FcConfigSubstitute);
  DURER_IMPORT(FcDefaultSubstitute);
  DURER_IMPORT(FcFontMatch);
  const bool ready = FcInit();
  // It holds its settings by offsets, which a leak check cannot follow.
  ~Fontconfig() { FcFini(); }
};

const Fontconfig& fontconfig() { return loaded<Fontconfig>(); }

struct PatternDeleter {
  void operator()(FcPattern* pattern) const { fontconfig().FcPatternDestroy(pattern); }
};
using Pattern = std::unique_ptr<FcPattern, PatternDeleter>;

const FcChar8* chars(const char* text) { return reinterpret_cast<const FcChar8*>(text); }

std::string file_of(FcPattern* pattern) {
  FcChar8* file = nullptr;
  if (fontconfig().FcPatternGetString(pattern, FC_FILE, 0, &file) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(file);
}

std::string last_part(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

// An installed font whose file has this name but for case.
std::string of_same_file_name(const std::string& file_name) {
  const Pattern any(fontconfig().FcPatternCreate());
  FcObjectSet* wanted = fontconfig().FcObjectSetBuild(FC_FILE, static_cast<char*>(nullptr));
  FcFontSet* fonts = fontconfig().FcFontList(nullptr, any.get(), wanted);
  fontconfig().FcObjectSetDestroy(wanted);
  std::string found;
  if (!fonts) return found;
  for (int i = 0; i < fonts->nfont; ++i) {
    const std::string file = file_of(fonts->fonts[i]);
    if (strcasecmp(last_part(file).c_str(), file_name.c_str()) != 0) continue;
    // The least path, so that the choice does not depend on the order of the list.
    if (found.empty() || file < found) found = file;
  }
  fontconfig().FcFontSetDestroy(fonts);
  return found;
}

struct Style {
  std::string family;
  bool bold = false, italic = false;
};

// What the short file names of other systems mean: "timesbi" is Times New Roman, bold and italic.
Style style_of(std::string stem) {
  std::transform(stem.begin(), stem.end(), stem.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr struct {
    const char* stem;
    const char* family;
  } kFamilies[] = {
      {"arial", "Arial"},       {"times", "Times New Roman"}, {"cour", "Courier New"},
      {"verdana", "Verdana"},   {"georgia", "Georgia"},       {"trebuc", "Trebuchet MS"},
      {"comic", "Comic Sans MS"}, {"calibri", "Calibri"},     {"cambria", "Cambria"},
      {"consola", "Consolas"},  {"timrom", "Times"},          {"cyrvetic", "Helvetica"},
  };
  static constexpr struct {
    const char* suffix;
    bool bold, italic;
  } kStyles[] = {{"bolditalic", true, true}, {"bold", true, false}, {"italic", false, true},
                 {"bd", true, false},        {"bi", true, true},    {"z", true, true},
                 {"b", true, false},         {"i", false, true}};
  for (const auto& known : kFamilies) {
    if (!stem.starts_with(known.stem)) continue;
    const std::string rest = stem.substr(std::string(known.stem).size());
    Style style{known.family};
    for (const auto& kind : kStyles) {
      if (rest.ends_with(kind.suffix)) {
        style.bold = kind.bold;
        style.italic = kind.italic;
        break;
      }
    }
    return style;
  }
  Style style{stem};
  style.bold = stem.find("bold") != std::string::npos;
  style.italic = stem.find("italic") != std::string::npos || stem.find("oblique") != std::string::npos;
  return style;
}

}  // namespace

std::string replacement_font(const std::string& name) {
  if (!fontconfig().ready) return {};
  const std::string file_name = last_part(name);
  std::string file = of_same_file_name(file_name);
  if (!file.empty()) return file;
  const Style style = style_of(file_name.substr(0, file_name.rfind('.')));
  const Pattern wanted(fontconfig().FcPatternCreate());
  fontconfig().FcPatternAddString(wanted.get(), FC_FAMILY, chars(style.family.c_str()));
  fontconfig().FcPatternAddInteger(wanted.get(), FC_WEIGHT, style.bold ? FC_WEIGHT_BOLD : FC_WEIGHT_NORMAL);
  fontconfig().FcPatternAddInteger(wanted.get(), FC_SLANT, style.italic ? FC_SLANT_ITALIC : FC_SLANT_ROMAN);
  fontconfig().FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  fontconfig().FcPatternAddString(wanted.get(), FC_FONTFORMAT, chars("TrueType"));
  fontconfig().FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  fontconfig().FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern match(fontconfig().FcFontMatch(nullptr, wanted.get(), &result));
  return match ? file_of(match.get()) : std::string();
}

}  // namespace durer
