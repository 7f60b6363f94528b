// What the encoders of BMP and Targa share: little-endian numbers, and rows of bytes with blue
// first.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

#include "tracer/image/picture_writer.h"
#include "tracer/image/quantize.h"

namespace durer {

// Bytes of a file, to be written at once. Numbers are little-endian.
class FileBytes {
 public:
  void byte(uint32_t value) { put(value, 1); }
  void word(uint32_t value) { put(value, 2); }
  void long_word(uint32_t value) { put(value, 4); }
  void zeros(size_t count) { bytes_.insert(bytes_.end(), count, 0); }
  // Filled up with zeros; `text` is no longer than `room`.
  void text(std::string_view text, size_t room) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    zeros(room - text.size());
  }
  void bytes(const uint8_t* from, size_t count) { bytes_.insert(bytes_.end(), from, from + count); }
  void clear() { bytes_.clear(); }
  size_t size() const { return bytes_.size(); }

  // Throws std::runtime_error with the system's message.
  void write(std::FILE* file) const;

 private:
  void put(uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<uint8_t>(value >> 8 * i));
  }

  std::vector<uint8_t> bytes_;
};

// A picture's rows as 8-bit codes: blue, green, red and, if the format has it, alpha.
class BlueFirstRows {
 public:
  // `format` has 8 bits and colour.
  BlueFirstRows(const Picture& picture, const PixelFormat& format);

  size_t width() const { return pixels_.size(); }
  size_t channels() const { return channels_; }
  // width() * channels() bytes, valid until the next call. Dithering goes in the order of the
  // calls.
  const std::vector<uint8_t>& read(int y);

 private:
  const Picture& picture_;
  size_t channels_;
  Quantizer quantizer_;
  std::vector<PixelColor> pixels_;
  std::vector<uint16_t> codes_;
  std::vector<uint8_t> row_;
};

}  // namespace durer
