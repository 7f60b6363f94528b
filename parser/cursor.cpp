// The executing stream of tokens: fetch() runs directives and macro calls until a token remains.
#include <algorithm>

#include "parser/parser_state.h"

namespace durer {

void Parser::State::turn_page(Frame& frame) {
  // An end_of_file stays where it is: it is read again and again.
  if (frame.page && !frame.page->tokens.empty() &&
      frame.page->tokens.back().kind == TokenKind::end_of_file) {
    frame.at = frame.page_end - 1;
    return;
  }
  uint32_t offset = frame.page->end;
  --frame.page->pins;
  do {
    frame.page = &frame.file->page_at(offset);
    offset = frame.page->end;
  } while (frame.page->tokens.empty());
  ++frame.page->pins;
  frame.at = frame.page->tokens.data();
  frame.page_end = frame.at + frame.page->tokens.size();
}

void Parser::State::seek(Frame& frame, uint32_t offset, uint32_t& guess) {
  TokenPage* page = frame.page;
  if (!page || offset < page->begin || offset >= page->end) {
    if (page) --page->pins;
    page = &frame.file->page_at(offset);
    ++page->pins;
    frame.page = page;
  }
  ++page->returns;
  const Token* begin = page->tokens.data();
  frame.page_end = begin + page->tokens.size();
  const bool guessed = guess > 0 && guess < page->tokens.size() && begin[guess].offset >= offset &&
                       begin[guess - 1].offset < offset;
  if (!guessed) {
    guess = static_cast<uint32_t>(
        std::lower_bound(begin, frame.page_end, offset,
                         [](const Token& token, uint32_t o) { return token.offset < o; }) -
        begin);
  }
  frame.at = begin + guess;
}

// At the end of a file the place of messages stays at the token before, as POV-Ray's does.
const Token& Parser::State::reach_odd_token(const Token& token) {
  if (token.kind == TokenKind::malformed) {
    last_offset = token.offset;
    last_file = frames.back().file.get();
    behind_last = false;
    raise_lexical(token);
  }
  Frame& frame = frames.back();
  if (last_file != frame.file.get()) {
    // What was read last is in a file that has ended: its #include is the place then.
    last_file = frame.file.get();
    last_offset = &token > frame.page->tokens.data() ? (&token)[-1].offset : frame.page->begin;
  }
  behind_last = true;
  return token;
}

const Token& Parser::State::raw_peek() {
  Frame& frame = frames.back();
  if (frame.at == frame.page_end) turn_page(frame);
  return *frame.at;
}

void Parser::State::push_frame(std::shared_ptr<SourceFile> file, uint32_t offset,
                               std::shared_ptr<const Macro> macro) {
  Frame& frame = frames.emplace_back();
  frame.file = std::move(file);
  frame.macro = std::move(macro);
  frame.open_conditionals = conditionals.size();
  if (frame.macro) {
    seek(frame, offset, frame.macro->body_token);
  } else {
    seek(frame, offset);
  }
}

void Parser::State::pop_frame() {
  --frames.back().page->pins;
  frames.pop_back();
  symbols.pop_scope();
}

void Parser::State::fetch() {
  for (;;) {
    if (ahead == kToken) return;
    const uint32_t offset_before = last_offset;
    SourceFile* const file_before = last_file;
    if (ahead == kNothing) {
      look.token = raw_next();
      look.entry = nullptr;
      look.value = nullptr;
    }
    ahead = kNothing;
    switch (look.token.kind) {
      case TokenKind::symbol:
        if (look.token.symbol != Symbol::hash) break;
        // The #end of a running macro returns from it even with directives off, and is no token.
        if (!conditionals.empty() && conditionals.back().kind == Conditional::Kind::macro_call &&
            raw_peek().is(Keyword::end)) {
          raw_next();
          return_from_macro();
          last_offset = offset_before;
          last_file = file_before;
          continue;
        }
        if (!directives_live) {
          // The `#` ends what is being read: what is missing is missing before it.
          last_offset = offset_before;
          last_file = file_before;
          behind_last = last_file != nullptr;
          ahead = kDeferred;
          return;
        }
        ++directive_depth;
        execute_directive();
        --directive_depth;
        continue;
      case TokenKind::identifier:
        if (fetch_identifier()) continue;
        if (ahead == kDeferred) return;
        break;
      case TokenKind::end_of_file:
        if (frames.size() > 1) {
          if (frames.back().macro) error("the file ended inside a macro: #end is missing");
          pop_frame();
          continue;
        }
        if (!conditionals.empty()) {
          const Conditional& open = conditionals.back();
          error("the file ended, but an #end is missing",
                "opened in line " + std::to_string(frames[open.frame].file->line_of(open.start)));
        }
        break;
      default:
        break;
    }
    if (waiting_switches > 0 && conditionals.back().kind == Conditional::Kind::switch_waiting &&
        conditionals.back().directive_depth == directive_depth) {
      error("expected #case or #range after #switch");
    }
    ahead = kToken;
    return;
  }
}

// True: a macro was called and the stream goes on with its body.
bool Parser::State::fetch_identifier() {
  Entry* entry = symbols.find(look.token.name);
  look.entry = entry;
  look.is_element = false;
  if (!entry) return false;
  look.value = entry->alias ? target_of(*entry) : &entry->value;
  if (!look.value) {
    look.entry = nullptr;
    return false;
  }
  if (!look.value->is_set()) {
    look.value = nullptr;
    return false;
  }
  if (entry->deprecation && !entry->deprecation->reported) {
    if (entry->deprecation->once) entry->deprecation->reported = true;
    message(Severity::warning, entry->deprecation->text);
  }
  if (look.value->kind() == ValueKind::macro) {
    if (!directives_live) {
      ahead = kDeferred;
      return false;
    }
    call_macro(look.value->handle<Macro>());
    return true;
  }
  if (look.value->kind() == ValueKind::array && resolve_elements &&
      raw_peek().is(Symbol::bracket_open)) {
    resolve_subscripts();
  }
  return false;
}

// Array elements appear in the stream as identifiers of the element's kind.
void Parser::State::resolve_subscripts() {
  const Token token = look.token;
  Entry* const entry = look.entry;
  const Reference reference = parse_element(*entry);
  look.token = token;
  look.entry = entry;
  look.value = readable(reference);
  look.is_element = true;
  look.reference = reference;
  ahead = kNothing;
}

const Value* Parser::State::readable(const Reference& reference) {
  if (!reference.entry->live) return nullptr;
  const Value* value = &reference.entry->value;
  for (int level = 0; level < reference.levels; ++level) {
    if (value->kind() != ValueKind::array) return nullptr;
    const Array& array = value->as<Array>();
    const int64_t index = reference.path[level];
    if (index < 0 || index >= static_cast<int64_t>(array.elements.size())) return nullptr;
    value = &array.elements[index];
  }
  return value;
}

void Parser::State::expect(Symbol symbol) {
  if (accept(symbol)) return;
  static constexpr const char* kText[] = {"'{'", "'}'", "'('", "')'", "'['", "']'", "'<'", "'>'",
                                          "'<='", "'>='", "'='", "'!='", "'+'", "'-'", "'*'", "'/'",
                                          "'&'", "'|'", "'!'", "'?'", "':'", "';'", "','", "'.'",
                                          "'#'"};
  error_expected(kText[static_cast<int>(symbol)]);
}

}  // namespace durer
