// Messages about a scene's text: what went wrong where, in our own words, with the line and a caret.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace durer {

enum class Severity : uint8_t {
  note,            // POV-Ray says nothing
  warning,         // POV-Ray's "Parse Warning"
  possible_error,  // POV-Ray's "Possible Parse Error"
  error,
  not_supported,   // read, but not rendered yet (tracer/scene/not_supported.h)
};

// A macro call or #include on the way to the place of a message.
struct DiagnosticFrame {
  std::string description;  // "in macro Tree", "included"
  std::string file;
  int line = 0;
};

struct Diagnostic {
  Severity severity = Severity::error;
  std::string text;
  std::string file;  // empty: not about a place
  int line = 0;      // 1-based, POV-Ray's rule: the line of the token read last
  int column = 0;    // 1-based, in bytes
  std::string source_line;
  std::vector<DiagnosticFrame> frames;  // innermost first
  std::string hint;                     // "did you mean ...", a fix; may be empty

  // file:line:column: error: text, then the line, the caret, the hint and the frames.
  std::string formatted() const;
};

// Ends the parse. Thrown by Parser::error, caught by parse_scene.
class ParseError : public std::runtime_error {
 public:
  explicit ParseError(Diagnostic d)
      : std::runtime_error(d.text), diagnostic(std::make_shared<Diagnostic>(std::move(d))) {}
  std::shared_ptr<const Diagnostic> diagnostic;
};

// Where messages and the scene's text streams go. The default does nothing.
// Where POV-Ray ends a line of text longer than `width`: before the last space of its last quarter,
// which then begins the next line, or at `width`.
size_t line_break(const std::string& text, size_t width);

class MessageSink {
 public:
  virtual ~MessageSink() = default;
  virtual void diagnostic(const Diagnostic&) {}
  // Whole lines of #debug (also #render, #statistics), in order, without the final newline.
  virtual void debug_line(const std::string&) {}
};

}  // namespace durer
