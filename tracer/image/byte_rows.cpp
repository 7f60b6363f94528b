#include "tracer/image/byte_rows.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace durer {

void FileBytes::write(std::FILE* file) const {
  if (std::fwrite(bytes_.data(), 1, bytes_.size(), file) != bytes_.size())
    throw std::runtime_error(std::strerror(errno));
}

BlueFirstRows::BlueFirstRows(const Picture& picture, const PixelFormat& format)
    : picture_(picture),
      channels_(static_cast<size_t>(format.channels())),
      quantizer_(format, picture.width()),
      pixels_(static_cast<size_t>(picture.width())),
      codes_(pixels_.size() * channels_),
      row_(codes_.size()) {}

const std::vector<uint8_t>& BlueFirstRows::read(int y) {
  constexpr std::array<size_t, 4> kOrder{2, 1, 0, 3};
  picture_.read(y, 0, picture_.width(), pixels_.data());
  quantizer_.quantize_row(y, pixels_.data(), codes_.data());
  for (size_t x = 0; x < pixels_.size(); ++x)
    for (size_t c = 0; c < channels_; ++c)
      row_[x * channels_ + c] = static_cast<uint8_t>(codes_[x * channels_ + kOrder[c]]);
  return row_;
}

}  // namespace durer
