// The face of the parser towards the statements.
#include "parser/parser.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "parser/parser_state.h"
#include "parser/part_count.h"
#include "parser/user_file.h"

namespace durer {

Parser::State::State(Parser& facade, const ParseOptions& parse_options)
    : parser(facade), options(parse_options) {
  if (options.version > 0) {
    language_version = options.version;
    version_seen = version_first = true;
    follow_noise_generator();
  }
}

Parser::State::~State() { close_files(); }

Parser::Parser(const ParseOptions& options) : state_(std::make_unique<State>(*this, options)) {}
Parser::~Parser() = default;

const Token& Parser::peek() { return state_->peek(); }
Token Parser::next() { return state_->next(); }
bool Parser::accept(Keyword keyword) { return state_->accept(keyword); }
bool Parser::accept_before_directives(Keyword keyword) {
  const FlagScope off(state_->directives_live, false);
  return state_->accept(keyword);
}
bool Parser::accept_bare_directive() { return state_->accept_bare_directive(); }
bool Parser::accept(Symbol symbol) { return state_->accept(symbol); }
bool Parser::accept_comma() { return state_->accept_comma(); }

bool Parser::at_any(std::initializer_list<Keyword> keywords) {
  const Token& token = state_->peek();
  return token.kind == TokenKind::keyword &&
         std::find(keywords.begin(), keywords.end(), token.keyword) != keywords.end();
}

void Parser::expect(Symbol symbol) { state_->expect(symbol); }

void Parser::expect(Keyword keyword) {
  if (!state_->accept(keyword)) error_expected("'" + std::string(spelling(keyword)) + "'");
}

void Parser::expect_open(const char* what) {
  if (!state_->accept(Symbol::brace_open)) error_expected(std::string("'{' after '") + what + "'");
  if (++state_->depth > state_->options.limits.max_expression_depth) {
    error("blocks are nested too deeply (limit " +
          std::to_string(state_->options.limits.max_expression_depth) + ")");
  }
}

void Parser::expect_close(const char* what) {
  if (!state_->accept(Symbol::brace_close)) {
    error_expected(std::string("'}' or an item of '") + what + "'");
  }
  --state_->depth;
}

double Parser::parse_float() { return state_->parse_float(); }
Vec2 Parser::parse_uv() { return state_->parse_uv(); }
Vec3 Parser::parse_vector() { return state_->parse_vector(); }
Vec4 Parser::parse_vec4() { return state_->parse_vec4(); }

int Parser::parse_int() {
  const double number = state_->parse_float();
  // What the processor makes of a number that no int can be.
  if (!(number > -2147483649.0 && number < 2147483648.0)) return std::numeric_limits<int>::min();
  return static_cast<int>(number);
}

Value Parser::parse_numeric() {
  Terms terms;
  state_->parse_parameter(terms, 1);
  return state_->to_value(terms);
}

bool Parser::at_expression() { return state_->starts_expression(); }

bool Parser::parse_optional_switch() {
  return !state_->starts_expression() || state_->parse_float() > 0;
}

double Parser::parse_optional_float(double otherwise) {
  return state_->starts_expression() ? state_->parse_float() : otherwise;
}

void Parser::parse_number_list(double* out, int count, const char* what) {
  if (!accept(Symbol::less)) error_expected(std::string("'<' and the numbers of ") + what);
  for (int i = 0; i < count; ++i) {
    out[i] = state_->parse_float();
    if (i + 1 < count) accept_comma();
  }
  if (!accept(Symbol::greater)) error_expected(std::string("'>' after the numbers of ") + what);
}

ColorRGBFT Parser::parse_color() {
  Terms terms;
  state_->parse_color(terms, true);
  return {static_cast<float>(terms.v[0]), static_cast<float>(terms.v[1]),
          static_cast<float>(terms.v[2]), static_cast<float>(terms.v[3]),
          static_cast<float>(terms.v[4])};
}

RGB Parser::parse_rgb() {
  Terms terms;
  state_->parse_color(terms, false);
  if (terms.v[3] != 0 || terms.v[4] != 0) {
    const char* which = terms.v[4] == 0   ? "filter has"
                        : terms.v[3] == 0 ? "transmit has"
                                          : "filter and transmit have";
    warning(std::string("this colour is pure RGB, its ") + which + " no effect");
  }
  return {static_cast<float>(terms.v[0]), static_cast<float>(terms.v[1]),
          static_cast<float>(terms.v[2])};
}

bool Parser::at_color_start() { return state_->starts_color() || at_identifier(ValueKind::color); }
bool Parser::at_string() { return state_->starts_string(); }
std::u16string Parser::parse_string() { return state_->parse_string(); }
std::string Parser::parse_path_string() { return state_->to_bytes(state_->parse_string(true)); }
std::string Parser::to_bytes(const std::u16string& text) const { return state_->to_bytes(text); }

bool Parser::at_identifier(ValueKind kind) {
  const Token& token = state_->peek();
  return token.kind == TokenKind::identifier && state_->look.value &&
         state_->look.value->kind() == kind;
}

const Value* Parser::peek_value() {
  const Token& token = state_->peek();
  return token.kind == TokenKind::identifier ? state_->look.value : nullptr;
}

Value Parser::take_identifier() {
  state_->peek();
  Value value = *state_->look.value;
  state_->consume();
  return value;
}

std::shared_ptr<const FunctionNode> Parser::parse_function(FunctionParameters defaults,
                                                           FunctionBodies bodies) {
  if (at(Symbol::paren_open)) error_expected("'{' after 'function'");
  return state_->parse_function(defaults, bodies);
}

void Parser::error(const std::string& text, const std::string& hint) { state_->error(text, hint); }

void Parser::error_expected(std::string_view what) {
  state_->peek();
  state_->error_expected(what);
}

void Parser::note(const std::string& text) { state_->message(Severity::note, text); }

void Parser::warning(const std::string& text) { state_->message(Severity::warning, text); }

void Parser::possible_error(const std::string& text) {
  state_->message(Severity::possible_error, text);
}

SourcePosition Parser::position() const { return state_->position(); }

void Parser::check_limit(uint64_t count, uint64_t limit, const char* name) {
  if (count > limit) error(std::string(name) + ": the limit is " + std::to_string(limit));
}

void Parser::check_nesting(ObjectNode& node) {
  node.csg_depth = static_cast<uint16_t>(state_->check_nesting(state_->nesting.levels(node)));
  node.parts = part_count(node);
  state_->check_parts("this stands for", static_cast<double>(node.parts));
}
void Parser::count_in_scene(const ObjectNode& node) {
  state_->scene_parts += static_cast<double>(node.parts);
  state_->check_parts("with this the scene has", state_->scene_parts);
}
void Parser::check_nesting(const std::shared_ptr<const PigmentNode>& node) {
  state_->check_nesting(state_->nesting.levels(node));
}
void Parser::check_nesting(const std::shared_ptr<const NormalNode>& node) {
  state_->check_nesting(state_->nesting.levels(node));
}
void Parser::check_nesting(const std::shared_ptr<const TextureNode>& node) {
  state_->check_nesting(state_->nesting.levels(node));
}

void Parser::State::check_parts(const char* what, double parts) {
  if (parts <= static_cast<double>(options.limits.max_objects)) return;
  char text[120];
  std::snprintf(text, sizeof text, "%s %.3g objects, copies counted; the limit is %.3g", what, parts,
                static_cast<double>(options.limits.max_objects));
  error(text, "--max-objects N raises it");
}

int Parser::State::check_nesting(int levels) {
  if (levels > options.limits.max_nodes_in_nodes) {
    error("objects, textures or patterns stand in each other more than " +
          std::to_string(options.limits.max_nodes_in_nodes) + " levels deep, which is the limit");
  }
  return levels;
}

int Parser::language_version() const { return state_->language_version; }

int Parser::effective_version() const {
  return state_->version_seen ? state_->language_version : 362;
}

const ParseOptions& Parser::options() const { return state_->options; }
Scene& Parser::scene() { return state_->scene; }
bool Parser::is_utf8() const { return state_->utf8; }

bool Parser::font_is_unicode(const std::string& name, const std::string& found) {
  auto& fonts = state_->unicode_fonts;
  if (const auto known = fonts.find(name); known != fonts.end()) return known->second;
  fonts[found] = is_utf8();
  return is_utf8();
}

void Parser::set_utf8(bool utf8) {
  state_->utf8 = utf8;
  state_->system_charset = false;
}
void Parser::set_system_charset() { state_->system_charset = true; }
void Parser::follow_noise_generator() { state_->follow_noise_generator(); }
void Parser::note_assumed_gamma() { state_->gamma_known = true; }
SceneQueries& Parser::queries() { return *state_->options.queries; }

void Parser::note_experimental(const char* feature) {
  std::vector<std::string>& known = state_->experimental;
  if (std::find(known.begin(), known.end(), feature) == known.end()) known.emplace_back(feature);
}

std::string Parser::find_file(const std::string& name, FileType type) {
  return state_->find_file(name, type, true);
}

std::string Parser::find_image(const std::string& name, ImageFileType type) {
  return state_->find_image(name, type);
}

}  // namespace durer
