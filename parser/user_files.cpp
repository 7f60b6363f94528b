// #fopen, #fclose, #read and #write (spec/language.md 17).
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <strings.h>
#include <utility>

#include "parser/lexer.h"
#include "parser/parser_state.h"
#include "parser/user_file.h"

namespace durer {
namespace {

enum class BinaryFormat { none, sint8, uint8, sint16be, sint16le, uint16be, uint16le, sint32be, sint32le };

BinaryFormat binary_format(const Token& token) {
  if (token.kind != TokenKind::keyword) return BinaryFormat::none;
  switch (token.keyword) {
    case Keyword::sint8: return BinaryFormat::sint8;
    case Keyword::uint8: return BinaryFormat::uint8;
    case Keyword::sint16be: return BinaryFormat::sint16be;
    case Keyword::sint16le: return BinaryFormat::sint16le;
    case Keyword::uint16be: return BinaryFormat::uint16be;
    case Keyword::uint16le: return BinaryFormat::uint16le;
    case Keyword::sint32be: return BinaryFormat::sint32be;
    case Keyword::sint32le: return BinaryFormat::sint32le;
    default: return BinaryFormat::none;
  }
}

void write_binary(std::FILE* stream, BinaryFormat format, double value) {
  double low = 0, high = 0;
  int bytes = 1;
  bool big_endian = false;
  switch (format) {
    case BinaryFormat::sint8: low = -128, high = 127; break;
    case BinaryFormat::uint8: low = 0, high = 255; break;
    case BinaryFormat::sint16be: big_endian = true; [[fallthrough]];
    case BinaryFormat::sint16le: low = -32768, high = 32767, bytes = 2; break;
    case BinaryFormat::uint16be: big_endian = true; [[fallthrough]];
    case BinaryFormat::uint16le: low = 0, high = 65535, bytes = 2; break;
    case BinaryFormat::sint32be: big_endian = true; [[fallthrough]];
    default: low = -2147483648.0, high = 2147483647.0, bytes = 4; break;
  }
  const double clamped = value > low ? (value < high ? std::floor(value + 0.5) : high) : low;
  const uint32_t bits = static_cast<uint32_t>(static_cast<int64_t>(clamped));
  for (int i = 0; i < bytes; ++i) {
    const int shift = 8 * (big_endian ? bytes - 1 - i : i);
    std::fputc(static_cast<int>((bits >> shift) & 0xff), stream);
  }
}

bool can_be_read_into(ValueKind kind) {
  return kind == ValueKind::number || kind == ValueKind::vector || kind == ValueKind::string;
}

}  // namespace

UserFile::~UserFile() { close(); }

void UserFile::close() {
  if (!stream) return;
  if (is_standard_stream) {
    std::fflush(stream);
  } else {
    std::fclose(stream);
  }
  stream = nullptr;
}

void Parser::State::close_files() {
  for (const auto& file : open_files) file->close();
  open_files.clear();
}

bool Parser::State::may_write(const std::string& path) const {
  if (options.writes.anywhere) return true;
  namespace fs = std::filesystem;
  std::error_code failed;
  // Links are followed, so that none leads outside.
  const fs::path target = fs::weakly_canonical(fs::absolute(path), failed);
  // A link to nothing is left as it is, and opening it would make its target.
  if (failed || fs::is_symlink(target)) return false;
  const auto below = [&](const fs::path& folder) {
    std::error_code bad;
    const fs::path base = fs::weakly_canonical(fs::absolute(folder.empty() ? fs::path(".") : folder), bad);
    if (bad) return false;
    const auto ends = std::mismatch(base.begin(), base.end(), target.begin(), target.end());
    return ends.first == base.end();
  };
  const fs::path current = fs::current_path(failed);
  if (!failed && below(current)) return true;
  if (!options.writes.output_folder.empty() && below(options.writes.output_folder)) return true;
  return std::any_of(options.writes.folders.begin(), options.writes.folders.end(), below);
}

void Parser::State::do_fopen() {
  const FlagScope plain(resolve_elements, false);
  const Token name = peek();
  if (name.kind != TokenKind::identifier || look.value) {
    error_expected("a new name for the file");
  }
  consume();
  const FlagScope elements(resolve_elements, true);
  auto file = std::make_shared<UserFile>();
  file->name = name.name;
  const std::string given = to_bytes(parse_string(true));
  if (accept(Keyword::read)) {
    file->mode = UserFile::Mode::read;
    file->path = find_file(given, FileType::user, true);
    if (file->path.empty()) error("cannot open the file '" + given + "' for reading");
    if (!read_file(file->path, options.limits.max_file_bytes, file->text)) {
      error("cannot read the file '" + given + "', or it is too long");
    }
  } else {
    const bool append = accept(Keyword::append);
    if (!append && !accept(Keyword::write)) error_expected("read, write or append");
    file->mode = append ? UserFile::Mode::append : UserFile::Mode::write;
    file->path = given;
    if (!append && strcasecmp(given.c_str(), "stdout") == 0) {
      file->stream = stdout;
      file->is_standard_stream = true;
    } else if (!append && strcasecmp(given.c_str(), "stderr") == 0) {
      file->stream = stderr;
      file->is_standard_stream = true;
    } else {
      if (!may_write(given)) {
        error("the scene may not write '" + given + "': it is outside the current and the output folder",
              "--allow-write FOLDER allows it, if you trust the scene");
      }
      file->stream = std::fopen(given.c_str(), append ? "ab" : "wb");
      written_files.push_back(given);
    }
    if (!file->stream) {
      error("cannot open the file '" + given + (append ? "' for appending" : "' for writing"));
    }
  }
  open_files.push_back(file);
  symbols.add(name.name, 0).value = Value(ValueKind::file, file);
}

void Parser::State::do_fclose() {
  peek();
  if (look.token.kind == TokenKind::identifier && look.value &&
      look.value->kind() == ValueKind::file) {
    Entry* entry = look.entry;
    auto& file = entry->value.mutable_as<UserFile>();
    consume();
    file.close();
    std::erase_if(open_files, [&](const auto& open) { return open.get() == &file; });
    symbols.remove(*entry);
    return;
  }
  // Anything else is swallowed.
  consume();
}

void Parser::State::do_read() {
  expect(Symbol::paren_open);
  peek();
  if (look.token.kind != TokenKind::identifier || !look.value ||
      look.value->kind() != ValueKind::file) {
    error_expected("the name of an open file");
  }
  Entry* file_entry = look.entry;
  const auto file = std::const_pointer_cast<UserFile>(look.value->handle<UserFile>());
  consume();
  if (file->mode != UserFile::Mode::read) {
    error("'" + file->path + "' is open for writing, it cannot be read");
  }
  accept_comma();
  bool ended = false;
  const auto end_file = [&] {
    ended = true;
    std::erase_if(open_files, [&](const auto& open) { return open == file; });
    if (file_entry->live) symbols.remove(*file_entry);
  };
  const auto space = [&] {
    uint32_t open_comment = kNoComment;
    file->at = skip_space(file->text, file->at, open_comment);
    return file->at < file->text.size();
  };
  const auto wrong = [&] {
    error_in_data(file->path, file->text, file->at, "expected a number, a vector or a string here");
  };
  const auto signed_number = [&]() {
    double sign = 1, value = 0;
    while (space() && file->text[file->at] == '+') ++file->at;
    if (space() && file->text[file->at] == '-') sign = -1, ++file->at;
    space();
    uint32_t end = file->at;
    if (!lex_number(file->text, file->at, value, end)) wrong();
    file->at = end;
    return sign * value;
  };
  while (!peek().is(Symbol::paren_close)) {
    if (look.token.kind != TokenKind::identifier) error_expected("an identifier to read into");
    const Name name = look.token.name;
    const bool element = look.is_element && look.value;
    Reference target;
    if (element) {
      target = look.reference;
    } else if (look.entry) {
      target = look.entry->alias ? *look.entry->alias : Reference{look.entry, 0, {}};
    }
    ValueKind kind = look.value ? look.value->kind() : ValueKind::unset;
    if (kind == ValueKind::unset && look.is_element) {
      Reference array = look.reference;
      --array.levels;
      kind = readable(array)->as<Array>().element_kind;
    }
    const bool without_value = kind == ValueKind::unset && !look.is_element;
    if (!without_value && !can_be_read_into(kind)) {
      error_expected("a new name, or a float, a vector or a string to read into");
    }
    consume();
    if (!ended) {
      // A new name is declared even if the file turns out to hold nothing more.
      if (!target.entry) target.entry = &symbols.add(name, 0);
      if (!space() || file->text[file->at] == '#') {
        end_file();
      } else {
        const char c = file->text[file->at];
        Value value;
        if (c == '"') {
          std::vector<Token> tokens;
          const uint32_t end = lex(file->text, file->at, 1, names, tokens);
          if (tokens[0].kind != TokenKind::string) wrong();
          value = Value(literal_in_data(*file, tokens[0], end));
          file->at = end;
        } else if (c == '<') {
          ++file->at;
          Terms terms{};
          terms.count = 0;
          for (;;) {
            if (!space()) wrong();
            if (file->text[file->at] == '>') break;
            if (terms.count == 5) wrong();
            terms.v[terms.count++] = signed_number();
            if (space() && file->text[file->at] == ',') ++file->at;
          }
          ++file->at;
          if (terms.count < 2) wrong();
          value = to_value(terms);
        } else {
          value = Value(signed_number());
        }
        store(target, std::move(value));
        // A comma, the end of the file, or a token that gets lost.
        if (!space()) {
          end_file();
        } else if (file->text[file->at] == ',') {
          ++file->at;
        } else {
          std::vector<Token> tokens;
          file->at = lex(file->text, file->at, 1, names, tokens);
        }
      }
    }
    accept_comma();
  }
  expect(Symbol::paren_close);
}

// A string of the file, `end` behind its quote. What is odd about it is said of the file's own line.
std::u16string Parser::State::literal_in_data(const UserFile& file, const Token& token, uint32_t end) {
  const auto is_plain = [](char c) { return c != '\\' && static_cast<unsigned char>(c) < 128; };
  const auto text = file.text.begin();
  if (!system_charset && std::all_of(text + file.at, text + end, is_plain)) {
    return std::u16string(text + file.at + 1, text + end - 1);
  }
  SourceFile data(file.path, file.text, names);
  SourceFile* const outer_file = std::exchange(last_file, &data);
  const uint32_t outer_offset = std::exchange(last_offset, token.offset);
  const std::u16string units = literal(token, data, false);
  last_file = outer_file;
  last_offset = outer_offset;
  return units;
}

void Parser::State::do_write() {
  expect(Symbol::paren_open);
  peek();
  if (look.token.kind != TokenKind::identifier || !look.value ||
      look.value->kind() != ValueKind::file) {
    error_expected("the name of an open file");
  }
  const auto file = std::const_pointer_cast<UserFile>(look.value->handle<UserFile>());
  consume();
  if (file->mode == UserFile::Mode::read || !file->stream) {
    error("'" + file->path + "' is not open for writing");
  }
  BinaryFormat format = BinaryFormat::none;
  while (!peek().is(Symbol::paren_close)) {
    // Commas may stand anywhere; one ends a run of binary values.
    if (accept_comma()) {
      format = BinaryFormat::none;
      continue;
    }
    const BinaryFormat wanted = binary_format(look.token);
    if (wanted != BinaryFormat::none) {
      format = wanted;
      consume();
      continue;
    }
    if (starts_string()) {
      if (format != BinaryFormat::none) error_expected("numbers to write as bytes");
      const std::string text = to_bytes(parse_string());
      std::fwrite(text.data(), 1, text.size(), file->stream);
    } else if (starts_expression() && !look.token.is(Keyword::t) &&
               !parser.at_identifier(ValueKind::color)) {
      Terms terms;
      parse_sum(terms, 1);
      if (format != BinaryFormat::none) {
        for (int i = 0; i < terms.count; ++i) write_binary(file->stream, format, terms.v[i]);
      } else if (terms.count == 1) {
        std::fprintf(file->stream, "%g", terms.v[0]);
      } else {
        for (int i = 0; i < terms.count; ++i) {
          std::fprintf(file->stream, "%c%g", i == 0 ? '<' : ',', terms.v[i]);
        }
        std::fputs("> ", file->stream);
      }
    } else {
      error_expected("a string or a numeric expression to write");
    }
  }
  expect(Symbol::paren_close);
}

}  // namespace durer
