#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace durer {

// A picture file in memory, read from its front: numbers are little-endian. Reading beyond its end
// throws std::runtime_error with a text for the user.
class ByteFile {
 public:
  explicit ByteFile(const std::string& path);

  uint8_t byte() { return *take(1); }
  uint16_t word() {
    const uint8_t* b = take(2);
    return static_cast<uint16_t>(b[0] | b[1] << 8);
  }
  uint32_t long_word() {
    const uint32_t low = word();
    return low | static_cast<uint32_t>(word()) << 16;
  }
  // The next `count` bytes.
  const uint8_t* take(size_t count) {
    if (count > bytes_.size() - position_)
      throw std::runtime_error("the image '" + path_ + "' is shorter than it says");
    position_ += count;
    return bytes_.data() + position_ - count;
  }
  void skip(size_t count) { take(count); }
  void step_back(size_t count) { position_ -= count; }
  void rewind() { position_ = 0; }

 private:
  std::string path_;
  std::vector<uint8_t> bytes_;
  size_t position_ = 0;
};

}  // namespace durer
