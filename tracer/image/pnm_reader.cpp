#include <cctype>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "tracer/image/raster_file.h"

namespace durer {
namespace {

// The bytes of a netpbm file. Its header is read by lines, as POV-Ray does: one for the size, one for the
// greatest value; what follows the numbers in a line is passed over.
class PnmText {
 public:
  explicit PnmText(const std::string& path)
      : path_(path), file_(std::fopen(path.c_str(), "rb"), &std::fclose) {
    if (!file_) throw std::runtime_error("the image '" + path + "' cannot be opened");
  }

  int byte() {
    const int c = std::getc(file_.get());
    if (c == EOF) end();
    return c;
  }
  // The next line that is neither empty nor a comment.
  std::string header_line() {
    std::string text;
    do text = line();
    while (text.empty() || text[0] == '#');
    return text;
  }
  // Of a plain file's pixels; `mask` is what a pixel can hold of it.
  int value(uint32_t mask) {
    int c = byte();
    while (std::isspace(c)) c = byte();
    if (!std::isdigit(c)) wrong();
    uint32_t number = 0;
    for (; std::isdigit(c); c = std::getc(file_.get())) {
      number = 10 * number + static_cast<uint32_t>(c - '0');
    }
    if (c != EOF && !std::isspace(c)) wrong();
    return static_cast<int>(number & mask);
  }
  void read(uint8_t* to, size_t count) {
    if (std::fread(to, 1, count, file_.get()) != count) end();
  }
  [[noreturn]] void wrong() const {
    throw std::runtime_error("the image '" + path_ + "' is no readable file of its kind, PPM or PGM");
  }

 private:
  [[noreturn]] void end() const {
    throw std::runtime_error("the image '" + path_ + "' is shorter than it says");
  }
  // Ends in CR, LF or both in any order; what is longer than POV-Ray's buffer counts as a further line.
  std::string line() {
    constexpr size_t kLongest = 1023;
    std::string text;
    int c = byte();
    for (; c != '\n' && c != '\r'; c = byte()) {
      if (text.size() == kLongest) {
        std::ungetc(c, file_.get());
        return text;
      }
      text += static_cast<char>(c);
    }
    const int partner = std::getc(file_.get());
    if (partner != (c == '\n' ? '\r' : '\n') && partner != EOF) std::ungetc(partner, file_.get());
    return text;
  }

  const std::string path_;
  std::unique_ptr<std::FILE, decltype(&std::fclose)> file_;
};

}  // namespace

RasterFile read_pnm(const std::string& path, ImageFileType type) {
  PnmText text(path);
  if (text.byte() != 'P') text.wrong();
  const int kind = text.byte() - '0';
  const bool is_plain = kind == 2 || kind == 3, has_colors = type == ImageFileType::ppm;
  if (kind != (has_colors ? 3 : 2) && kind != (has_colors ? 6 : 5)) text.wrong();
  RasterFile file;
  int maximum = 0;
  if (std::sscanf(text.header_line().c_str(), "%d %d", &file.width, &file.height) != 2 ||
      std::sscanf(text.header_line().c_str(), "%d", &maximum) != 1 || maximum < 1 || maximum > 65535) {
    text.wrong();
  }
  check_size(path, file.width, file.height);
  file.maximum = maximum;
  file.channels = has_colors ? 3 : 1;
  file.bits = maximum > 255 ? 16 : 8;
  const size_t count = static_cast<size_t>(file.width) * static_cast<size_t>(file.height) *
                       static_cast<size_t>(file.channels);
  if (file.bits == 8) {
    file.bytes.resize(count);
    if (is_plain) {
      for (uint8_t& value : file.bytes) value = static_cast<uint8_t>(text.value(0xff));
    } else {
      text.read(file.bytes.data(), count);
    }
  } else {
    file.words.resize(count);
    if (is_plain) {
      for (uint16_t& value : file.words) value = static_cast<uint16_t>(text.value(0xffff));
    } else {
      std::vector<uint8_t> bytes(2 * count);
      text.read(bytes.data(), bytes.size());
      for (size_t i = 0; i < count; ++i) {
        file.words[i] = static_cast<uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]);
      }
    }
  }
  return file;
}

}  // namespace durer
