// Strings: 16-bit units, literals and the string functions (spec/language.md 1, 2, 10).
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>

#include "parser/parser_state.h"

namespace durer {
namespace {

int truncated(double number) {
  if (!(number > -2147483649.0 && number < 2147483648.0)) return std::numeric_limits<int>::min();
  return static_cast<int>(number);
}

// C's %f or %g with a width and a precision given as numbers.
std::string format_number(double value, int length, int precision, char style) {
  char format[16];
  if (precision < 0) {
    std::snprintf(format, sizeof format, length < 0 ? "%%0*%c" : "%%*%c", style);
  } else {
    std::snprintf(format, sizeof format, length < 0 ? "%%0*.*%c" : "%%*.*%c", style);
  }
  const int width = length < 0 ? -length : length;
  char text[512];
  const int size = precision < 0 ? std::snprintf(text, sizeof text, format, width, value)
                                 : std::snprintf(text, sizeof text, format, width, precision, value);
  if (size >= 0 && size < static_cast<int>(sizeof text)) return std::string(text, static_cast<size_t>(size));
  if (size < 0 || size > 1000000) return std::string(100000, ' ');
  std::string longer(static_cast<size_t>(size) + 1, '\0');
  if (precision < 0) {
    std::snprintf(longer.data(), longer.size(), format, width, value);
  } else {
    std::snprintf(longer.data(), longer.size(), format, width, precision, value);
  }
  longer.pop_back();
  return longer;
}

std::string str_text(double value, int length, int precision) {
  if (length == std::numeric_limits<int>::min()) length = -255;
  std::string text = format_number(value, length, precision, 'f');
  if (text.size() < 255) return text;
  text = format_number(value, length, precision, 'g');
  return text.size() < 255 ? text : "<invalid>";
}

std::u16string widen(const std::string& text) {
  std::u16string wide;
  wide.reserve(text.size());
  for (const char c : text) wide += static_cast<unsigned char>(c);
  return wide;
}

}  // namespace

bool Parser::State::starts_string() {
  const Token& token = peek();
  if (token.kind == TokenKind::string) return true;
  if (token.kind == TokenKind::identifier) {
    return look.value && look.value->kind() == ValueKind::string;
  }
  if (token.kind != TokenKind::keyword) return false;
  switch (token.keyword) {
    case Keyword::str: case Keyword::vstr: case Keyword::concat: case Keyword::chr:
    case Keyword::substr: case Keyword::strupr: case Keyword::strlwr: case Keyword::datetime:
      return true;
    default:
      return false;
  }
}

// Bytes of a literal to units by the scene's charset (spec/language.md 1).
std::u16string Parser::State::from_bytes(const std::string& bytes) {
  std::u16string units;
  units.reserve(bytes.size());
  for (size_t i = 0; i < bytes.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(bytes[i]);
    if (c < 128) {
      units += c;
    } else if (utf8) {
      // No validation: the lead byte alone says how many bytes follow, and what the marks of all
      // of them add up to is taken off at the end. Behind the end stand zeros.
      static constexpr uint32_t kMarks[] = {0, 0x3080, 0xe2080, 0x3c82080, 0xfa082080, 0x82082080};
      const int more = c < 0xc0 ? 0 : c < 0xe0 ? 1 : c < 0xf0 ? 2 : c < 0xf8 ? 3 : c < 0xfc ? 4 : 5;
      uint32_t code = c;
      for (int k = 0; k < more; ++k) {
        code <<= 6;
        if (i + 1 < bytes.size()) code += static_cast<unsigned char>(bytes[++i]);
      }
      code -= kMarks[more];
      units += static_cast<char16_t>(code > 0xffff ? 0xfffd : code);
    } else if (language_version >= 350) {
      message(Severity::possible_error, "a character that is not ASCII was replaced by a space");
      units += u' ';
    } else {
      units += c;
    }
  }
  return units;
}

std::string Parser::State::to_bytes(const std::u16string& text) const {
  std::string bytes;
  bytes.reserve(text.size());
  for (const char16_t unit : text) {
    bytes += unit < 128 ? static_cast<char>(unit) : language_version >= 350 ? ' ' : static_cast<char>(unit);
  }
  return bytes;
}

std::u16string Parser::State::literal(const Token& token, const SourceFile& file, bool path) {
  if (system_charset) {
    error("strings cannot be read in the charset 'sys', which is not known on this system",
          "global_settings { charset utf8 } is what you probably want");
  }
  const std::u16string raw = from_bytes(file.literal_at(token.offset));
  if (path || raw.find(u'\\') == std::u16string::npos) return raw;
  std::u16string text;
  for (size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] != u'\\') {
      text += raw[i];
      continue;
    }
    const char16_t escape = i + 1 < raw.size() ? raw[++i] : u'\0';
    switch (escape) {
      case u'a': text += u'\a'; break;
      case u'b': text += u'\b'; break;
      case u't': text += u'\t'; break;
      case u'n': text += u'\n'; break;
      case u'v': text += u'\v'; break;
      case u'f': text += u'\f'; break;
      case u'r': text += u'\r'; break;
      case u'\'': text += u'\''; break;
      case u'\\': text += u'\\'; break;
      case u'u': {
        if (i + 4 >= raw.size()) {
          error("the escape sequence \\u needs four hexadecimal digits");
        }
        char digits[5] = {};
        for (int d = 0; d < 4; ++d) {
          const char16_t unit = raw[++i];
          digits[d] = unit < 128 ? static_cast<char>(unit) : ' ';
        }
        const char16_t unit = static_cast<char16_t>(std::strtoul(digits, nullptr, 16));
        if (unit == 0) return text;  // ends the string
        text += unit;
        break;
      }
      default:
        error("this escape sequence does not exist in strings",
              "write \\\\ for a backslash, or use / in names of files");
    }
  }
  return text;
}

std::u16string Parser::State::parse_string(bool path) {
  const NestingScope deeper(*this);
  {
    const FlagScope on(directives_live, true);
    peek();
  }
  const Token token = look.token;
  if (token.kind == TokenKind::string) {
    const SourceFile& file = *last_file;
    consume();
    return literal(token, file, path);
  }
  if (token.kind == TokenKind::identifier) {
    if (!look.value) {
      error_undeclared(token.name);
    }
    if (look.value->kind() == ValueKind::string) {
      std::u16string text = look.value->string();
      consume();
      return text;
    }
    error_expected("a string");
  }
  if (token.kind != TokenKind::keyword) error_expected("a string");
  const auto open = [&] {
    consume();
    expect(Symbol::paren_open);
  };
  const auto close = [&] { expect(Symbol::paren_close); };
  const FlagScope on(directives_live, true);
  switch (token.keyword) {
    case Keyword::str: {
      open();
      const double value = parse_float();
      accept_comma();
      const int length = truncated(parse_float());
      accept_comma();
      const int precision = truncated(parse_float());
      close();
      return widen(str_text(value, length, precision));
    }
    case Keyword::vstr: {
      open();
      const int count = std::min(5, std::max(2, truncated(parse_float())));
      accept_comma();
      Terms terms;
      parse_sum(terms, 1);
      accept_comma();
      const std::u16string separator = parse_string();
      accept_comma();
      const int length = truncated(parse_float());
      accept_comma();
      const int precision = truncated(parse_float());
      close();
      std::u16string text;
      for (int i = 0; i < count; ++i) {
        if (i > 0) text += separator;
        text += widen(format_number(terms.v[i], length, precision, 'f'));
      }
      return text;
    }
    case Keyword::concat: {
      open();
      // In the name of a file only the first argument has its escapes processed (section 2).
      std::u16string text = parse_string();
      while (accept_comma() || !peek().is(Symbol::paren_close)) {
        text += parse_string(path);
        if (text.size() > options.limits.max_string_bytes) error("the string is too long");
      }
      close();
      return text;
    }
    case Keyword::chr: {
      open();
      const double value = std::trunc(parse_float_express());
      close();
      if (!(value >= 0 && value <= 65535)) {
        error("chr() takes numbers from 0 to 65535");
      }
      if (value == 0) return {};
      return std::u16string(1, static_cast<char16_t>(value));
    }
    case Keyword::substr: {
      open();
      const std::u16string text = parse_string();
      accept_comma();
      const long long position = truncated(parse_float());
      accept_comma();
      const long long length = truncated(parse_float());
      close();
      if (position < 0 || length < 0 || position + length - 1 > static_cast<long long>(text.size())) {
        error("substr() asks for characters outside the string");
      }
      if (position == 0 || position > static_cast<long long>(text.size())) return {};
      return text.substr(static_cast<size_t>(position - 1), static_cast<size_t>(length));
    }
    case Keyword::strupr:
    case Keyword::strlwr: {
      open();
      std::u16string text = parse_string(path);
      close();
      bool warned = false;
      for (char16_t& unit : text) {
        if (unit > 127 && !warned) {
          message(Severity::warning, "strupr and strlwr change ASCII letters only");
          warned = true;
        }
        if (token.keyword == Keyword::strupr && unit >= u'a' && unit <= u'z') unit -= 32;
        if (token.keyword == Keyword::strlwr && unit >= u'A' && unit <= u'Z') unit += 32;
      }
      return text;
    }
    case Keyword::datetime: {
      open();
      const double days = parse_float();
      std::string format = "%Y-%m-%d %H:%M:%SZ";
      if (accept_comma() || !peek().is(Symbol::paren_close)) format = to_bytes(parse_string());
      close();
      if (format.empty()) error("the format of datetime() is empty");
      if (format.size() > 200) error("the format of datetime() is longer than 200 characters");
      const double seconds = std::floor((days + 10957.0) * 86400.0 + 0.5);
      // A date that the calendar cannot hold is that of time 0.
      constexpr double kMostSeconds = 6e16;
      std::time_t time = std::fabs(seconds) < kMostSeconds ? static_cast<std::time_t>(seconds) : 0;
      std::tm fields{};
      char text[255];
      if (!gmtime_r(&time, &fields) || std::strftime(text, sizeof text, format.c_str(), &fields) == 0) {
        error("the format of datetime() is not valid, or its result is too long");
      }
      return widen(text);
    }
    default:
      error_expected("a string");
  }
}

}  // namespace durer
