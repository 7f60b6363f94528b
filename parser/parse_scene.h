// The entry of this room: a file name goes in, a Scene or an error comes out.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "parser/diagnostics.h"
#include "parser/scene_queries.h"
#include "tracer/scene/scene.h"

namespace durer {


// What a scene may use up before it is stopped with an error that names the limit.
struct ParserLimits {
  uint64_t max_loop_turns = 100'000'000;    // of all loops together
  int max_include_depth = 32;               // POV-Ray's; the main file counts
  int max_nesting = 199;                    // conditionals, loops and running macros (POV-Ray's)
  int max_symbol_tables = 98;               // below the global one (POV-Ray's)
  int max_expression_depth = 1000;          // parentheses, brackets and braces inside each other
  int max_nodes_in_nodes = 500;             // textures, patterns, CSG and bounds inside each other
  uint64_t max_array_elements = 100'000'000;
  uint64_t max_objects = 1'000'000'000;     // shapes of the scene, copies counted
  uint64_t max_string_bytes = 64'000'000;   // of one string
  uint64_t max_file_bytes = 4'000'000'000;  // of one source file
};

// Which files a scene may write (reading is as free as the user's own).
struct WritePermissions {
  bool anywhere = false;
  std::string output_folder;  // besides the current folder; empty: none
  std::vector<std::string> folders;  // further ones that the user allows
};

struct ParseOptions {
  std::string input_file;
  std::string input_name;  // as the user wrote it; empty: input_file
  std::vector<std::string> library_paths;
  std::string include_header;  // read before the first token; empty: none

  // clock and animation (spec/language.md 11)
  double clock = 0;
  bool clock_given = false;
  int image_width = 160, image_height = 120;
  int frame_number = 0, initial_frame = 0, final_frame = 0;
  double initial_clock = 0, final_clock = 0, clock_delta = 0;
  // Declare=name=value, in order; the first of a name wins. Values in quotes are strings.
  std::vector<std::pair<std::string, std::string>> declares;
  int version = 0;            // hundredths, from Version= or +MV; 0: not given
  bool output_alpha = false;  // background{} depends on it (spec/language.md 24)
  bool remove_bounds = true;  // only a warning depends on it

  ParserLimits limits;
  WritePermissions writes;
  std::shared_ptr<SceneQueries> queries;  // null: the ones of tracer/world
  MessageSink* sink = nullptr;            // null: messages are dropped
};

struct ParseResult {
  std::unique_ptr<Scene> scene;               // null: the parse failed
  std::shared_ptr<const Diagnostic> failure;  // null: it did not
};

// Never throws for anything that the text says. NotSupported (tracer/scene/not_supported.h) passes.
ParseResult parse_scene(const ParseOptions& options);

}  // namespace durer
