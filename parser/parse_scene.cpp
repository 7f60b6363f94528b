#include "parser/parse_scene.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "parser/parser_state.h"
#include "parser/statements/statements.h"
#include "parser/world_queries.h"
#include "tracer/scene/not_supported.h"

namespace durer {
namespace {

// Six significant digits of the single-precision value: how automatic identifiers get their numbers.
double declared_number(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g", static_cast<double>(static_cast<float>(value)));
  return std::atof(text);
}

void declare(Parser::State& state, const std::string& name, Value value) {
  const Name id = state.names.intern(name);
  // The first of a name wins; reserved words cannot be declared.
  if (id < static_cast<Name>(kKeywordCount) || state.symbols.find(id)) return;
  state.symbols.add(id, 0).value = std::move(value);
}

// Command line and INI first, then what every scene finds declared (spec/language.md 11.2).
void declare_globals(Parser::State& state) {
  const ParseOptions& o = state.options;
  for (const auto& [name, text] : o.declares) {
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
      declare(state, name, Value(state.from_bytes(text.substr(1, text.size() - 2))));
    } else {
      declare(state, name, Value(declared_number(std::atof(text.c_str()))));
    }
  }
  const std::string& input = o.input_name.empty() ? o.input_file : o.input_name;
  // rfind's npos plus one is 0: the whole name.
  declare(state, "input_file_name", Value(state.from_bytes(input.substr(input.rfind('/') + 1))));
  const std::pair<const char*, double> numbers[] = {
      {"image_width", o.image_width},       {"image_height", o.image_height},
      {"frame_number", o.frame_number},     {"initial_frame", o.initial_frame},
      {"final_frame", o.final_frame},       {"initial_clock", o.initial_clock},
      {"final_clock", o.final_clock},       {"clock_delta", o.clock_delta},
  };
  for (const auto& [name, value] : numbers) declare(state, name, Value(declared_number(value)));
}

void open_main_file(Parser::State& state) {
  const std::string& path = state.options.input_file;
  std::shared_ptr<SourceFile> file = state.load_source(path);
  // Bytes above 127 at the start (a byte order mark) switch strings to UTF-8.
  uint32_t start = 0;
  while (start < file->text().size() && static_cast<unsigned char>(file->text()[start]) > 127) ++start;
  if (start > 0) state.utf8 = true;
  state.push_frame(std::move(file), start, nullptr);
  if (!state.options.include_header.empty()) {
    const std::string header = state.find_file(state.options.include_header, FileType::include, true);
    if (header.empty()) {
      state.error("cannot find the header file '" + state.options.include_header + "'");
    }
    state.symbols.push_scope();
    state.push_frame(state.load_source(header), 0, nullptr);
  }
}

// spec/language.md 27, the core's part.
void finish(Parser::State& state) {
  state.last_file = nullptr;  // these messages are about no place
  state.behind_last = false;
  Scene& scene = state.scene;
  if (scene.objects.empty()) state.message(Severity::warning, "the scene has no objects");
  if (!state.experimental.empty()) {
    std::string text = "this scene uses features that POV-Ray calls experimental:";
    for (const std::string& feature : state.experimental) text += " " + feature + ",";
    text.pop_back();
    state.message(Severity::warning, text);
  }
  state.follow_noise_generator();
  scene.settings.noise_generator = state.field_settings->noise_generator;
  state.field_settings->number_of_waves = scene.settings.number_of_waves;
  state.field_settings->frozen = true;
  if (!state.gamma_known && state.parser.effective_version() >= 370) {
    state.message(Severity::possible_error,
                  "assumed_gamma is not given: 1.0 is used; write "
                  "global_settings { assumed_gamma 1.0 }");
  } else if (!state.gamma_known) {
    state.message(Severity::warning,
                  "assumed_gamma is not given: colours are not corrected for the display, "
                  "as before 3.7");
  }
  if (state.language_version < 350) {
    state.message(Severity::warning,
                  "this scene is written for a version of POV-Ray before 3.5: some features may look "
                  "different");
    state.language_version = 350;
  }
  if (!state.version_seen) {
    state.message(Severity::warning,
                  "this scene has no #version directive: it is read as 3.7, and rendered by the rules "
                  "of 3.6");
  } else if (!state.version_first) {
    state.message(Severity::warning,
                  "this scene has other statements before its first #version directive");
  }
  scene.language_version = state.language_version;
  scene.effective_version = state.parser.effective_version();
}

}  // namespace

ParseResult parse_scene(const ParseOptions& options) {
  ParseResult result;
  Parser parser(options);
  Parser::State& state = parser.state();
  if (!state.options.queries) {
    state.options.queries = make_world_queries(parser);
  }
  try {
    declare_globals(state);
    open_main_file(state);
    parse_scene_statements(parser);
    finish(state);
    state.close_files();
    result.scene = std::make_unique<Scene>(std::move(state.scene));
  } catch (const ParseError& failure) {
    result.failure = failure.diagnostic;
  } catch (const std::bad_alloc&) {
    Diagnostic diagnostic;
    diagnostic.text = "out of memory while reading the scene";
    diagnostic.hint = "--max-memory MB sets the limit";
    result.failure = std::make_shared<Diagnostic>(std::move(diagnostic));
  }
  return result;
}

}  // namespace durer
