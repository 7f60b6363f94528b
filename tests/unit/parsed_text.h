// Scenes given as text: what they print with #debug, what they hold.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "parser/parse_scene.h"

namespace durer {

struct ParsedText {
  std::unique_ptr<Scene> scene;     // null: failed
  std::vector<std::string> debug;   // lines of #debug
  std::string error;                // empty: none
};

// Files that the text names are looked for in tests/data and among POV-Ray's includes.
inline ParsedText parse_text(const std::string& text) {
  struct Collector : MessageSink {
    std::vector<std::string> lines;
    void debug_line(const std::string& line) override { lines.push_back(line); }
  };
  const auto path = std::filesystem::temp_directory_path() /
                    ("durer-test-" + std::to_string(getpid()) + ".pov");
  std::ofstream(path) << text;
  Collector collector;
  ParseOptions options;
  options.input_file = path.string();
  options.library_paths = {std::string(DURER_SOURCE_DIR) + "/tests/data",
                           "/usr/share/povray-3.7/include"};
  options.sink = &collector;
  ParseResult result = parse_scene(options);
  std::filesystem::remove(path);
  return {std::move(result.scene), std::move(collector.lines),
          result.failure ? result.failure->formatted() : std::string()};
}

}  // namespace durer
