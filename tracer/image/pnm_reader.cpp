#include <cctype>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "tracer/image/raster_file.h"

namespace durer {
namespace {

// The bytes of a netpbm file; numbers are separated by white space and comments.
class PnmText {
 public:
  explicit PnmText(const std::string& path)
      : path_(path), file_(std::fopen(path.c_str(), "rb"), &std::fclose) {
    if (!file_) throw std::runtime_error("the image '" + path + "' cannot be opened");
  }

  int byte() {
    const int c = std::getc(file_.get());
    if (c == EOF) throw std::runtime_error("the image '" + path_ + "' is shorter than it says");
    return c;
  }
  int number(int most) {
    int c = byte();
    for (; std::isspace(c) || c == '#'; c = byte()) {
      if (c == '#') while (c != '\n' && c != '\r') c = byte();
    }
    int value = 0;
    for (; std::isdigit(c) && value <= most; c = last_ ? std::getc(file_.get()) : byte()) {
      value = 10 * value + (c - '0');
    }
    if (value > most || !(std::isspace(c) || c == EOF || c == '#')) wrong();
    behind_number_ = c;
    return value;
  }
  // Pixels begin behind the character that ends the last number, or in the next line if nothing but
  // blanks or a comment is left of this one.
  void end_header() {
    int c = behind_number_;
    while (behind_number_ == '#' && c != '\n') c = byte();
    const long begin = std::ftell(file_.get());
    while (c == ' ' || c == '\t' || c == '\r') c = std::getc(file_.get());
    if (c != '\n') std::fseek(file_.get(), begin, SEEK_SET);
  }
  void read(uint8_t* to, size_t count) {
    if (std::fread(to, 1, count, file_.get()) != count) byte();
  }
  // From here on the file may end after a number.
  void in_pixels() { last_ = true; }
  [[noreturn]] void wrong() const {
    throw std::runtime_error("the image '" + path_ + "' is no readable file of its kind, PPM or PGM");
  }

 private:
  const std::string path_;
  std::unique_ptr<std::FILE, decltype(&std::fclose)> file_;
  bool last_ = false;
  int behind_number_ = 0;
};

}  // namespace

RasterFile read_pnm(const std::string& path, ImageFileType type) {
  PnmText text(path);
  if (text.byte() != 'P') text.wrong();
  const int kind = text.byte() - '0';
  const bool is_plain = kind == 2 || kind == 3, has_colors = type == ImageFileType::ppm;
  if (kind != (has_colors ? 3 : 2) && kind != (has_colors ? 6 : 5)) text.wrong();
  RasterFile file;
  file.width = text.number(1 << 24);
  file.height = text.number(1 << 24);
  const int maximum = text.number(65535);
  if (maximum < 1) text.wrong();
  text.end_header();
  check_size(path, file.width, file.height);
  file.maximum = maximum;
  file.channels = has_colors ? 3 : 1;
  file.bits = maximum > 255 ? 16 : 8;
  const size_t count = static_cast<size_t>(file.width) * static_cast<size_t>(file.height) *
                       static_cast<size_t>(file.channels);
  text.in_pixels();
  if (file.bits == 8) {
    file.bytes.resize(count);
    if (is_plain) {
      for (uint8_t& value : file.bytes) value = static_cast<uint8_t>(text.number(maximum));
    } else {
      text.read(file.bytes.data(), count);
    }
  } else {
    file.words.resize(count);
    if (is_plain) {
      for (uint16_t& value : file.words) value = static_cast<uint16_t>(text.number(maximum));
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
