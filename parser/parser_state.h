// The inside of class Parser: the executing token stream with its directives, the evaluator of
// expressions, files. For the .cpp files of this folder only; statements use parser.h.
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "parser/array.h"
#include "parser/macro.h"
#include "parser/nesting.h"
#include "parser/parser.h"
#include "parser/source.h"
#include "parser/symbol_table.h"
#include "tracer/field/field_settings.h"
#include "tracer/scene/scene.h"

namespace durer {

class CompiledFunction;
class Spline;
struct UserFile;

// One to five numbers on their way through an expression. Those behind `count` are what a selection
// (`V.y`) or a short vector left there: a context that wants a vector takes them as they are.
struct Terms {
  double v[5] = {};
  int count = 1;

  // Floats are replicated, vectors padded with zeros (spec/language.md 5.2).
  void promote(int width) {
    if (width <= count) return;
    const double fill = count == 1 ? v[0] : 0.0;
    for (int i = count; i < width; ++i) v[i] = fill;
    count = width;
  }
  void set_float(double number, int width) {
    for (int i = 0; i < width; ++i) v[i] = number;
    count = width;
  }
};

// Where tokens come from: a file being included, or a macro's body being replayed.
struct Frame {
  std::shared_ptr<SourceFile> file;
  TokenPage* page = nullptr;
  const Token* at = nullptr;
  const Token* page_end = nullptr;
  std::shared_ptr<const Macro> macro;  // null: an included file
  size_t open_conditionals = 0;        // how many there were when it began
};

struct Conditional {
  enum class Kind : uint8_t {
    if_taken, else_taken, while_loop, for_loop, switch_waiting, switch_matched, macro_call,
  };
  Kind kind;
  size_t frame = 0;        // index of the frame that it began in
  uint32_t start = 0;      // loops: offset of the condition or the body; others: of the directive
  uint32_t start_token = 0;  // for Parser::State::seek()
  Name variable = 0;       // #for
  double end = 0, step = 0;
  double switch_value = 0;
  int directive_depth = 0;  // #switch: where tokens before the first label are a mistake
};

struct Parser::State {
  State(Parser& facade, const ParseOptions& parse_options);
  ~State();

  // ---- cursor.cpp: the stream -----------------------------------------------------------------
  struct Lookahead {
    Token token;
    Entry* entry = nullptr;        // identifiers: what the name stands for, or null
    // The variable or the array element; null: undeclared, or a variable without a value.
    const Value* value = nullptr;
    bool is_element = false;
    Reference reference;           // of an element: for macro arguments
  };
  // 0: nothing read ahead; 1: `#` or a macro name, read with directives off and to be executed
  // when they are on again; 2: a token.
  enum Ahead : uint8_t { kNothing = 0, kDeferred = 1, kToken = 2 };

  const Token& peek() {
    if (ahead == kToken || (ahead == kDeferred && !directives_live)) return look.token;
    fetch();
    return look.token;
  }
  void consume() {
    ahead = kNothing;
    ++consumed;
  }
  Token next() {
    const Token token = peek();
    consume();
    return token;
  }
  bool accept(Symbol symbol) {
    if (!peek().is(symbol)) return false;
    consume();
    return true;
  }
  bool accept(Keyword keyword) {
    if (!peek().is(keyword)) return false;
    consume();
    return true;
  }
  void expect(Symbol symbol);
  bool accept_comma() { return accept(Symbol::comma); }
  // The next raw token of the current frame, without executing anything.
  const Token& raw_next() {
    Frame& frame = frames.back();
    if (frame.at == frame.page_end) turn_page(frame);
    const Token& token = *frame.at++;
    if (token.kind >= TokenKind::end_of_file) [[unlikely]] return reach_odd_token(token);
    last_offset = token.offset;
    last_file = frame.file.get();
    behind_last = false;
    return token;
  }
  const Token& reach_odd_token(const Token& token);
  const Token& raw_peek();
  void turn_page(Frame& frame);
  // `guess`: the place of that token in its page, if it is still the same; the place found.
  void seek(Frame& frame, uint32_t offset, uint32_t& guess);
  void seek(Frame& frame, uint32_t offset) {
    uint32_t guess = 0;
    seek(frame, offset, guess);
  }
  void fetch();
  bool fetch_identifier();
  void resolve_subscripts();
  void push_frame(std::shared_ptr<SourceFile> file, uint32_t offset,
                  std::shared_ptr<const Macro> macro);
  void pop_frame();
  // What an alias stands for in the end; null: it is gone.
  static const Value* target_of(const Entry& entry) { return readable(*entry.alias); }
  // The variable or element that a reference names; null: it is gone.
  static const Value* readable(const Reference& reference);

  // ---- conditionals.cpp -----------------------------------------------------------------------
  enum class Landing : uint8_t { end, else_branch, elseif_branch, case_label, range_label };
  void do_if();
  void do_ifdef(bool wanted);
  void do_else();
  void do_elseif();
  void do_while();
  void do_for();
  void do_switch();
  void do_case(bool range);
  void do_break();
  void do_end();
  bool parse_condition();
  bool parse_case_label(bool range, double value);
  bool parse_defined();
  // Skips tokens, levels inside levels, to the end of the `levels`-th open level. With
  // `stop_at_branches` it stops at #else, #elseif, #case, #range of the first level, too.
  Landing skip(int levels, bool stop_at_branches);
  void skip_after_failed_if();
  void skip_to_matching_label(size_t conditional);
  void open_conditional(Conditional::Kind kind, uint32_t start);
  void count_turn();

  // ---- directives.cpp -------------------------------------------------------------------------
  void execute_directive();
  bool accept_bare_directive();
  void do_declare(bool local);
  void do_undef();
  void do_include();
  void do_version();
  // The noise generator in force, for functions that are evaluated while the scene is read.
  void follow_noise_generator();
  void do_message(Keyword which);
  Reference begin_declaration(Name name, bool local, uint32_t scope);
  void parse_target_element(Reference& target);
  void check_semicolon(bool numeric);
  void write_debug(const std::string& text);

  struct RightSide {
    Value value;
    bool numeric = false;  // needs a semicolon after #declare
    Reference reference;   // exactly one identifier: what it names
    bool is_reference = false;
  };

  // ---- macros.cpp -----------------------------------------------------------------------------
  void do_macro();
  void call_macro(const std::shared_ptr<const Macro>& macro);
  void return_from_macro();
  void keep_if_scope_ends(RightSide& argument);

  // ---- values.cpp -----------------------------------------------------------------------------
  // A #declare's right-hand side, a macro argument or an array element.
  void parse_right_side(RightSide& result, const char* what);
  bool take_numeric_identifier(RightSide& result);
  Value parse_array();
  void parse_array_level(Array& array, int dimension, int64_t& index);
  // Reads all subscripts that follow: into the array, into the array in that element ...
  void parse_subscripts(Reference& reference);
  // The element that the subscripts after an array's name stand for.
  Reference parse_element(Entry& array);
  int64_t parse_flat_index(const ArrayShape& shape);
  // The variable or element that a reference names, for writing; arrays on the way are unshared.
  Value* writable(const Reference& reference);
  void store(const Reference& reference, Value value);
  void check_depth(const Array& array);
  std::shared_ptr<const Spline> parse_spline();

  // ---- expression.cpp -------------------------------------------------------------------------
  void parse_sum(Terms& out, int width);
  void parse_term(Terms& out, int width);
  void parse_factor(Terms& out, int width);
  void parse_primary(Terms& out, int width);
  void parse_express(Terms& out, int width);
  void parse_logical(Terms& out, int width);
  void parse_relation(Terms& out, int width);
  void parse_member(Terms& out);
  void parse_parameter(Terms& out, int width);  // `sum`, or `factor` before version 1.5
  // For expressions that are read again and again (compiled_expression.h): the value, everything
  // consumed; false: nothing has happened.
  // A variable alone is no value where it would be passed by reference.
  enum class Alone : uint8_t { value, reference };
  bool evaluate_compiled(Terms& out, int width, ExpressionLevel level, Alone alone = Alone::value);
  CompiledExpression* compiled_at(const Token*& first, int width, ExpressionLevel level);
  std::unique_ptr<CompiledExpression> compile_expression(const TokenPage& page, size_t first,
                                                         int width, ExpressionLevel level) const;
  const Token* next_raw() const;
  bool run(CompiledExpression& code);
  // What the name stands for if reading it needs no message; null otherwise.
  const Value* plain_value(Name name) const {
    const Entry* entry = symbols.find(name);
    if (!entry || entry->deprecation) return nullptr;
    return entry->alias ? target_of(*entry) : &entry->value;
  }
  const Value* plain_element(const CompiledExpression::Step& step, const double* registers,
                             ValueKind kind) const;
  void pass_tokens(const Token* first, uint32_t count);
  double parse_float();
  double parse_float_express();
  Vec2 parse_uv();
  Vec3 parse_vector();
  Vec4 parse_vec4();
  void finish_vector(Terms& terms, int width);
  void call_function(Terms& out, const FunctionNode& function, int width);
  void call_spline(Terms& out, const Spline& spline, int width);
  bool starts_expression();
  Value to_value(const Terms& terms);

  // ---- builtins.cpp ---------------------------------------------------------------------------
  // Float and vector functions and constants; the keyword has been consumed. False: it is none.
  bool parse_builtin(Keyword keyword, Terms& out, int width);
  static bool is_builtin(Keyword keyword);
  double next_random(double stream);
  double new_random_stream(double seed);

  // ---- colors.cpp -----------------------------------------------------------------------------
  void parse_color(Terms& out, bool full);
  bool starts_color();

  // ---- string_expressions.cpp -----------------------------------------------------------------
  bool starts_string();
  std::u16string parse_string(bool path = false);
  std::u16string literal(const Token& token, const SourceFile& file, bool path);
  std::string to_bytes(const std::u16string& text) const;
  std::u16string from_bytes(const std::string& bytes);

  // ---- user_files.cpp, file_search.cpp --------------------------------------------------------
  void do_fopen();
  void do_fclose();
  void do_read();
  void do_write();
  std::u16string literal_in_data(const UserFile& file, const Token& token, uint32_t end);
  void close_files();
  // The number itself; an error above the limit.
  int check_nesting(int levels);
  void check_parts(const char* what, double parts);
  double scene_parts = 0;  // of the objects at scene level so far
  bool may_write(const std::string& path) const;
  std::string find_file(const std::string& name, FileType type, bool forgiving);
  std::string find_image(const std::string& name, ImageFileType type);
  // With the extensions that a name may lack, best first.
  using Extensions = std::initializer_list<const char*>;
  std::string find_as_written(const std::string& name, Extensions extensions) const;
  std::string find_forgivingly(const std::string& name, Extensions extensions);
  // A file or folder of that name, here or in a library path.
  bool path_exists(const std::string& name) const;
  std::shared_ptr<SourceFile> load_source(const std::string& path);

  // ---- functions.cpp --------------------------------------------------------------------------
  struct FunctionParameter {
    Name name = 0;
    int special = -1;  // x or u: 0, y or v: 1, z: 2
  };
  std::shared_ptr<const FunctionNode> parse_function(FunctionParameters defaults,
                                                     FunctionBodies bodies);
  std::vector<FunctionParameter> parse_function_parameters();
  std::shared_ptr<const CompiledFunction> parse_function_body(
      const std::vector<FunctionParameter>& parameters);

  // ---- messages.cpp ---------------------------------------------------------------------------
  [[noreturn]] void error(const std::string& text, const std::string& hint = {});
  [[noreturn]] void error_expected(std::string_view what);
  [[noreturn]] void error_undeclared(Name name);
  [[noreturn]] void error_few_arguments(const Macro& macro, size_t given);
  [[noreturn]] void error_nested_macros();
  [[noreturn]] void raise_lexical(const Token& token);
  // An error in a file that the scene reads as data.
  [[noreturn]] void error_in_data(const std::string& path, const std::string& text, uint32_t offset,
                                  const std::string& what);
  void message(Severity severity, const std::string& text);
  Diagnostic diagnostic_here(Severity severity, const std::string& text);
  std::string found();
  std::string quoted(Name name) const;
  std::string suggestion(Name name);
  SourcePosition position();

  // ---- data -----------------------------------------------------------------------------------
  Parser& parser;
  ParseOptions options;
  Scene scene;
  NameTable names;
  SymbolTable symbols;
  std::vector<Frame> frames;
  std::vector<Conditional> conditionals;
  Lookahead look;
  Ahead ahead = kNothing;
  bool directives_live = true;
  bool resolve_elements = true;   // off while the left side of #declare is read
  int waiting_switches = 0;       // #switch directives that look for their first label
  int directive_depth = 0;        // directives and macro calls whose own tokens are being read
  uint64_t declarations = 0;      // #declare and #local executed so far
  uint64_t consumed = 0;          // tokens handed out so far
  uint32_t last_offset = 0;       // of the token read last
  SourceFile* last_file = nullptr;
  bool behind_last = false;  // messages are about what is missing behind that token
  std::vector<std::shared_ptr<SourceFile>> all_files;  // keeps every file that was read
  int depth = 0;                  // of expressions and blocks
  uint64_t loop_turns = 0;
  int language_version = 370;
  bool version_seen = false;
  bool version_first = false;
  bool utf8 = false;
  std::map<std::string, bool> unicode_fonts;  // by the names under which they were found
  bool system_charset = false;  // POV-Ray on Unix stops at the first string then
  bool gamma_known = false;
  std::shared_ptr<FieldSettings> field_settings = std::make_shared<FieldSettings>();
  Name declaring = 0;  // what #declare is about to give a value to: a function may call itself
  std::vector<uint32_t> random_streams;
  std::string debug_line;
  std::vector<std::string> experimental;
  Nesting nesting;
  int function_levels = 0;  // of the functions that the function being read calls
  std::vector<std::shared_ptr<UserFile>> open_files;
  std::unordered_map<std::string, std::shared_ptr<SourceFile>> sources;  // by path
  std::map<std::pair<std::string, ImageFileType>, std::weak_ptr<const RasterFile>> images;
  std::vector<std::string> written_files;  // by #fopen: their cached text is stale
};

// Counts how deep expressions, calls and blocks stand inside each other, also when an error unwinds
// them: each level takes some of the program's stack.
class NestingScope {
 public:
  explicit NestingScope(Parser::State& state) : depth_(state.depth) {
    if (++depth_ > state.options.limits.max_expression_depth) {
      state.error("expressions, calls and blocks stand in each other more than " +
                  std::to_string(state.options.limits.max_expression_depth) +
                  " levels deep, which is the limit");
    }
  }
  ~NestingScope() { --depth_; }
  NestingScope(const NestingScope&) = delete;
  NestingScope& operator=(const NestingScope&) = delete;

 private:
  int& depth_;
};

// Sets a flag for a scope.
class FlagScope {
 public:
  FlagScope(bool& flag, bool value) : flag_(flag), old_(flag) { flag = value; }
  ~FlagScope() { flag_ = old_; }
  FlagScope(const FlagScope&) = delete;
  FlagScope& operator=(const FlagScope&) = delete;

 private:
  bool& flag_;
  bool old_;
};

}  // namespace durer
