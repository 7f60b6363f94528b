#include "parser/source.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdio>

#include "parser/lexer.h"

namespace durer {
namespace {

constexpr size_t kTokensPerPage = 1024;
constexpr size_t kMostPages = 256;  // 4 MB of tokens per file
constexpr uint64_t kMostOfDevice = 64'000'000;

}  // namespace

SourceFile::SourceFile(std::string name, std::string text, NameTable& names)
    : name_(std::make_shared<const std::string>(std::move(name))),
      text_(std::move(text)),
      names_(names) {}

TokenPage& SourceFile::page_at(uint32_t offset) {
  // The last page that begins at or before the offset.
  auto after = std::upper_bound(pages_.begin(), pages_.end(), offset,
                                [](uint32_t o, const auto& page) { return o < page->begin; });
  if (after != pages_.begin()) {
    TokenPage& page = **(after - 1);
    const bool last_of_file =
        !page.tokens.empty() && page.tokens.back().kind == TokenKind::end_of_file;
    if (offset < page.end || last_of_file) {
      page.last_used = ++clock_;
      return page;
    }
  }
  auto page = std::make_unique<TokenPage>();
  page->begin = offset;
  page->last_used = ++clock_;
  page->tokens.reserve(std::min<size_t>(kTokensPerPage, (text_.size() - std::min<size_t>(offset, text_.size())) / 2 + 2));
  page->end = lex(text_, offset, kTokensPerPage, names_, page->tokens);
  // Never overlap the next page: the same token must not live in two. A page may end up empty.
  if (after != pages_.end() && page->end > (*after)->begin) {
    const uint32_t limit = (*after)->begin;
    while (!page->tokens.empty() && page->tokens.back().offset >= limit) page->tokens.pop_back();
    page->end = limit;
  }
  TokenPage& result = *page;
  pages_.insert(after, std::move(page));
  if (pages_.size() > kMostPages) {
    ++result.pins;
    drop_old_pages();
    --result.pins;
  }
  return result;
}

void SourceFile::drop_old_pages() {
  // The older half of what nobody reads from.
  std::vector<uint64_t> ages;
  for (const auto& page : pages_) {
    if (!page->pins) ages.push_back(page->last_used);
  }
  if (ages.empty()) return;
  std::nth_element(ages.begin(), ages.begin() + ages.size() / 2, ages.end());
  const uint64_t oldest_kept = ages[ages.size() / 2];
  std::erase_if(pages_, [&](const auto& page) { return !page->pins && page->last_used < oldest_kept; });
}

void SourceFile::scan_lines_to(uint32_t offset) {
  const uint32_t size = static_cast<uint32_t>(text_.size());
  while (lines_scanned_ <= offset && lines_scanned_ < size) {
    const char c = text_[lines_scanned_++];
    if (c != '\n' && c != '\r') continue;
    // CR LF and LF CR are one newline.
    if (lines_scanned_ < size && text_[lines_scanned_] == (c == '\n' ? '\r' : '\n')) ++lines_scanned_;
    line_starts_.push_back(lines_scanned_);
  }
}

int SourceFile::line_of(uint32_t offset) {
  if (offset >= lines_scanned_) scan_lines_to(offset);
  const bool is_last = last_line_ == line_starts_.size();
  if (line_starts_[last_line_ - 1] > offset || (!is_last && line_starts_[last_line_] <= offset)) {
    const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
    last_line_ = static_cast<size_t>(after - line_starts_.begin());
  }
  return static_cast<int>(last_line_);
}

int SourceFile::column_of(uint32_t offset) {
  return static_cast<int>(offset - line_starts_[line_of(offset) - 1]) + 1;
}

std::string SourceFile::line_text(int line) {
  if (line < 1 || line > static_cast<int>(line_starts_.size())) return {};
  const size_t begin = line_starts_[line - 1];
  size_t end = begin;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
  return text_.substr(begin, end - begin);
}

std::string SourceFile::literal_at(uint32_t offset) const {
  std::string body;
  for (size_t i = offset + 1; i < text_.size() && text_[i] != '"'; ++i) {
    if (text_[i] == '\\' && i + 1 < text_.size()) {
      if (text_[i + 1] != '"') body += '\\';
      body += text_[++i];
    } else if (text_[i] == '\r' || text_[i] == '\n') {
      // Every newline style is one LF.
      if (i + 1 < text_.size() && text_[i + 1] == (text_[i] == '\n' ? '\r' : '\n')) ++i;
      body += '\n';
    } else {
      body += text_[i];
    }
  }
  return body;
}

bool read_file(const std::string& path, uint64_t most_bytes, std::string& content) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) return false;
  content.clear();
  // A device has no size, and may have no end.
  struct stat status;
  if (fstat(fileno(file), &status) == 0 && S_ISCHR(status.st_mode)) {
    most_bytes = std::min(most_bytes, kMostOfDevice);
  }
  size_t got = 0;
  bool good = true;
  // Size first where it is known; then whatever is left (pipes, growing files).
  if (std::fseek(file, 0, SEEK_END) == 0) {
    const long size = std::ftell(file);
    good = std::fseek(file, 0, SEEK_SET) == 0 && size >= 0 &&
           static_cast<uint64_t>(size) <= most_bytes;
    if (good && size > 0) {
      content.resize(static_cast<size_t>(size));
      got = std::fread(content.data(), 1, content.size(), file);
      content.resize(got);
    }
  }
  char buffer[65536];
  while (good && (got = std::fread(buffer, 1, sizeof buffer, file)) > 0) {
    content.append(buffer, got);
    good = content.size() <= most_bytes;
  }
  good = good && !std::ferror(file);
  std::fclose(file);
  return good;
}

}  // namespace durer
