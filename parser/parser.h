// The parser: one executing stream of tokens, expressions over it, and what statements need.
//
// Statements (parser/statements/) read with peek/accept/expect and the parse_* functions. Directives
// (#declare, #if, macros ...) are executed by the stream between two tokens and never seen
// (spec/language.md 4). Reading ahead is one token deep: peek() may execute directives, so peek only
// when the statement is at the place where the token would be read.
#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/diagnostics.h"
#include "parser/parse_scene.h"
#include "parser/token.h"
#include "parser/value.h"
#include "tracer/scene/color.h"
#include "tracer/scene/image_source.h"
#include "tracer/scene/source_position.h"

namespace durer {

struct FunctionNode;
struct CameraNode;
struct NormalNode;
struct ObjectNode;
struct PigmentNode;
struct TextureNode;
struct Scene;

// Which parameters function{ } has when it names none.
enum class FunctionParameters : uint8_t { xyz, uvw };

// What may stand in the braces: an expression only, or also pattern{}, pigment{}, transform{}, spline{}.
enum class FunctionBodies : uint8_t { expressions, any };

enum class FileType : uint8_t { include, user, font, density };

class Parser {
 public:
  explicit Parser(const ParseOptions& options);
  ~Parser();
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  // ---- Tokens --------------------------------------------------------------------------------
  // The next token, directives before it executed. Macro calls have been expanded.
  const Token& peek();
  Token next();
  bool at(Keyword keyword) { return peek().is(keyword); }
  bool at(Symbol symbol) { return peek().is(symbol); }
  bool at_any(std::initializer_list<Keyword> keywords);
  bool at_end() { return peek().kind == TokenKind::end_of_file; }
  // Consume the token if it is this one.
  bool accept(Keyword keyword);
  bool accept(Symbol symbol);
  // The same without executing directives to get at the token (spec/language.md 4): a `#` or a macro
  // is then not this keyword.
  bool accept_before_directives(Keyword keyword);
  // `declare`, `include` and `default` without `#`, which works between statements.
  bool accept_bare_directive();
  // Consume it or stop with an error that says what was expected.
  void expect(Symbol symbol);
  void expect(Keyword keyword);
  // `{` after / `}` of a block; `what` is the statement's word, for the message ("sphere").
  void expect_open(const char* what);
  void expect_close(const char* what);
  // Zero or one comma: commas between parameters are optional in the language.
  bool accept_comma();

  // ---- Numbers (spec/language.md 5), level `sum` ----------------------------------------------
  double parse_float();
  Vec2 parse_uv();
  Vec3 parse_vector();
  Vec4 parse_vec4();
  // A float truncated to int (saturating; NaN gives the least int).
  int parse_int();
  // Numbers, colours or vectors of any width 1..5, as a Value of the kind that width has.
  Value parse_numeric();
  // True if the next token can start a numeric expression (numbers, `<`, `(`, signs, functions,
  // numeric identifiers, x y z u v pi clock ...).
  bool at_expression();
  // `hollow [F]`: on if the value is left out or > 0.
  bool parse_optional_switch();
  // `F` if an expression follows, else the given value.
  double parse_optional_float(double otherwise);
  // `<` n floats, commas optional `>`.
  void parse_number_list(double* out, int count, const char* what);

  // ---- Colours (spec/language.md 6) -----------------------------------------------------------
  // Full colour; may be empty (then black).
  ColorRGBFT parse_color();
  // Pure RGB contexts: filter and transmit are dropped with a warning.
  RGB parse_rgb();
  // A colour keyword, `color`, or a colour identifier follows.
  bool at_color_start();
  // The same, or a bare number or vector (pattern lists, light colours).
  bool at_color_or_expression() { return at_color_start() || at_expression(); }

  // ---- Strings (spec/language.md 10) ----------------------------------------------------------
  bool at_string();
  std::u16string parse_string();
  // For names of files: escapes are left alone. Bytes, as the language converts them.
  std::string parse_path_string();
  // Conversion of 16-bit units to bytes by the version's rule (spec/language.md 1).
  std::string to_bytes(const std::u16string& text) const;

  // ---- Identifiers ----------------------------------------------------------------------------
  // True if the next token is an identifier (or an array element) that holds this kind.
  bool at_identifier(ValueKind kind);
  // Consumes it and returns what it holds, or null. T must be the type that the kind names:
  // `accept_identifier<PigmentNode>(ValueKind::pigment)`.
  template <typename T>
  std::shared_ptr<const T> accept_identifier(ValueKind kind) {
    if (!at_identifier(kind)) return nullptr;
    return take_identifier().handle<T>();
  }
  // The value that the next token names; null if it is no identifier. Good until the next read.
  const Value* peek_value();
  // Consumes the identifier token and returns a copy of its value.
  Value take_identifier();

  // ---- Functions (spec/language.md 23) --------------------------------------------------------
  // After the word `function` of a statement: { body }.
  std::shared_ptr<const FunctionNode> parse_function(
      FunctionParameters defaults, FunctionBodies bodies = FunctionBodies::expressions);

  // ---- Long literal lists ---------------------------------------------------------------------
  // Reads as many plain `<a,b,c>` items (with the comma after each) as stand literally in the text,
  // without making tokens, and appends them; stops before the first item that is anything else
  // (call parse_vector() for that one and then this again). At most `most` items. Returns how many.
  size_t parse_literal_vectors(std::vector<glm::vec3>& out, size_t most);
  size_t parse_literal_vectors(std::vector<Vec3>& out, size_t most);
  size_t parse_literal_vectors(std::vector<Vec2>& out, size_t most);
  size_t parse_literal_vectors(std::vector<std::array<int32_t, 3>>& out, size_t most);
  // The same for plain numbers.
  size_t parse_literal_numbers(std::vector<double>& out, size_t most);

  // ---- Messages (spec/language.md 28) ---------------------------------------------------------
  // All name the place of the token read last (the one looked at, if it was only peeked).
  [[noreturn]] void error(const std::string& text, const std::string& hint = {});
  // "expected WHAT, found ...", with a suggestion if the word found is near a known one.
  [[noreturn]] void error_expected(std::string_view what);
  void note(const std::string& text);
  void warning(const std::string& text);
  void possible_error(const std::string& text);
  // Place of the token read last; cheap enough to call once per node.
  SourcePosition position() const;
  // Stops with an error if `count` is above the limit; name appears in the message.
  void check_limit(uint64_t count, uint64_t limit, const char* name);
  // Stops with an error if textures, patterns or objects stand in each other too deeply in this node
  // (parser/nesting.h); with an object under construction also if it stands for too many shapes
  // (parser/part_count.h). Notes both in it.
  void check_nesting(const std::shared_ptr<const PigmentNode>& node);
  void check_nesting(const std::shared_ptr<const NormalNode>& node);
  void check_nesting(const std::shared_ptr<const TextureNode>& node);
  void check_nesting(ObjectNode& node);
  // The same for all objects at scene level together: call it once for each.
  void count_in_scene(const ObjectNode& node);

  // ---- Versions, settings, scene --------------------------------------------------------------
  // Hundredths: 370. The language version L and the effective version E (spec/language.md 19).
  int language_version() const;
  int effective_version() const;
  const ParseOptions& options() const;
  Scene& scene();
  // #default { camera{} }; null: the built-in one.
  std::shared_ptr<const CameraNode> default_camera;
  // Inside #default { }, where a pigment may leave its colour open.
  bool in_default_block = false;
  // `global_settings { charset utf8 }`.
  void set_utf8(bool utf8);
  bool is_utf8() const;
  // Whether texts in this font take their characters by Unicode. As in povray the charset at the first
  // use decides, for as long as the font is called by the name under which it was found last.
  bool font_is_unicode(const std::string& name, const std::string& found);
  // `charset sys`: an error as soon as a string is read.
  void set_system_charset();
  // noise_generator or #version has changed.
  void follow_noise_generator();
  // "spline", "slope pattern" ...: named in one warning after the parse.
  void note_experimental(const char* feature);
  // assumed_gamma has been parsed (srgb colours need it); gamma as in GlobalSettings.
  void note_assumed_gamma();
  SceneQueries& queries();

  // ---- Files ----------------------------------------------------------------------------------
  // Finds a file as the language does (extensions, current folder, library paths); failing that,
  // ignoring case and with `\` read as `/`, with a warning. Empty: not found.
  std::string find_file(const std::string& name, FileType type);
  // The same for an image; its kind decides which extensions are tried.
  std::string find_image(const std::string& name, ImageFileType type);
  // Each file once, as long as something shares it. An error if it cannot be read.
  std::shared_ptr<const RasterFile> read_image(const std::string& path, ImageFileType type);

  // The executing stream and everything behind it (parser/parser_state.h); for the core only.
  struct State;
  State& state() { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

}  // namespace durer
