// Long lists of literal numbers and vectors, read from the text without making tokens: meshes with
// millions of triangles spend their parse here.
#include <array>

#include "parser/lexer.h"
#include "parser/parser_state.h"

namespace durer {
namespace {

// Reads one kind of item from plain text. Every function leaves `at` alone when the text is not the
// plain form, so that the tokens' way can take over.
class LiteralReader {
 public:
  LiteralReader(const std::string& text, uint32_t at) : text_(text), at_(at) {}

  uint32_t at() const { return at_; }

  // An optionally signed number.
  bool number(double& value) {
    uint32_t p = space(at_);
    const bool negative = p < text_.size() && text_[p] == '-';
    if (negative) p = space(p + 1);
    uint32_t end = p;
    if (!lex_number(text_, p, value, end)) return false;
    if (negative) value = -value;
    at_ = end;
    return true;
  }

  // `<` count numbers `>`, commas or white space between them.
  bool vector(double* values, int count) {
    const uint32_t start = at_;
    uint32_t p = space(at_);
    if (p >= text_.size() || text_[p] != '<') return false;
    at_ = p + 1;
    for (int i = 0; i < count; ++i) {
      if (i > 0) {
        p = space(at_);
        if (p < text_.size() && text_[p] == ',') {
          at_ = p + 1;
        } else if (p >= text_.size() || (text_[p] != '.' && (text_[p] < '0' || text_[p] > '9'))) {
          // A sign without a comma is an operator.
          at_ = start;
          return false;
        }
      }
      if (!number(values[i])) {
        at_ = start;
        return false;
      }
    }
    p = space(at_);
    if (p >= text_.size() || text_[p] != '>') {
      at_ = start;
      return false;
    }
    at_ = p + 1;
    return true;
  }

  // What must follow an item for it to be whole: a comma (taken), `}`, or for vectors the next `<`.
  bool item_ends(bool vectors) {
    const uint32_t p = space(at_);
    if (p >= text_.size()) return false;
    if (text_[p] == ',') {
      at_ = p + 1;
      return true;
    }
    if (text_[p] == '}') return true;
    return vectors && text_[p] == '<';
  }

  void back_to(uint32_t at) { at_ = at; }

 private:
  uint32_t space(uint32_t p) const {
    while (p < text_.size() && (text_[p] == ' ' || text_[p] == '\n')) ++p;
    if (p < text_.size() && text_[p] != '/' && static_cast<unsigned char>(text_[p]) > ' ') return p;
    uint32_t open_comment = kNoComment;
    return skip_space(text_, p, open_comment);
  }

  const std::string& text_;
  uint32_t at_;
};

template <typename ReadItem>
size_t read_items(Parser::State& state, size_t most, bool vectors, ReadItem read_item) {
  state.peek();
  Frame& frame = state.frames.back();
  // The token looked at must stand in the frame's own text, not come from a macro that ended.
  if (state.last_file != frame.file.get() || frame.at == frame.page->tokens.data() ||
      frame.at[-1].offset != state.look.token.offset) {
    return 0;
  }
  const TokenKind kind = state.look.token.kind;
  if (kind != TokenKind::symbol && kind != TokenKind::number) return 0;
  LiteralReader reader(frame.file->text(), state.look.token.offset);
  size_t count = 0;
  while (count < most) {
    const uint32_t start = reader.at();
    if (!read_item(reader, false) || !reader.item_ends(vectors)) {
      reader.back_to(start);
      break;
    }
    read_item(reader, true);
    ++count;
  }
  if (count > 0) {
    state.ahead = Parser::State::kNothing;
    state.consumed += count;
    state.seek(frame, reader.at());
    state.last_offset = reader.at() - 1;
  }
  return count;
}

template <typename Item, int kCount, typename Make>
size_t read_vectors(Parser::State& state, std::vector<Item>& out, size_t most, Make make) {
  std::array<double, kCount> values{};
  return read_items(state, most, true, [&](LiteralReader& reader, bool keep) {
    if (!keep) return reader.vector(values.data(), kCount);
    out.push_back(make(values));
    return true;
  });
}

}  // namespace

size_t Parser::parse_literal_vectors(std::vector<glm::vec3>& out, size_t most) {
  return read_vectors<glm::vec3, 3>(*state_, out, most, [](const std::array<double, 3>& v) {
    return glm::vec3(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]));
  });
}

size_t Parser::parse_literal_vectors(std::vector<Vec3>& out, size_t most) {
  return read_vectors<Vec3, 3>(
      *state_, out, most, [](const std::array<double, 3>& v) { return Vec3(v[0], v[1], v[2]); });
}

size_t Parser::parse_literal_vectors(std::vector<Vec2>& out, size_t most) {
  return read_vectors<Vec2, 2>(*state_, out, most,
                               [](const std::array<double, 2>& v) { return Vec2(v[0], v[1]); });
}

size_t Parser::parse_literal_vectors(std::vector<std::array<int32_t, 3>>& out, size_t most) {
  using Index = std::array<int32_t, 3>;
  return read_vectors<Index, 3>(*state_, out, most, [](const std::array<double, 3>& v) {
    // Saturated: indices out of range are the statement's to report.
    const auto index = [](double d) {
      return d > 2147483647.0 ? 2147483647 : d < -2147483648.0 ? INT32_MIN : static_cast<int32_t>(d);
    };
    return Index{index(v[0]), index(v[1]), index(v[2])};
  });
}

size_t Parser::parse_literal_numbers(std::vector<double>& out, size_t most) {
  double value = 0;
  return read_items(*state_, most, false, [&](LiteralReader& reader, bool keep) {
    if (!keep) return reader.number(value);
    out.push_back(value);
    return true;
  });
}

}  // namespace durer
