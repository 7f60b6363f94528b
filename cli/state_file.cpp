#include "cli/state_file.h"

#include <unistd.h>

namespace durer {
namespace {

constexpr auto kWriteInterval = std::chrono::seconds(5);

bool block_fits(const PixelWindow& block, const Framebuffer& picture) {
  return block.left >= 0 && block.top >= 0 && block.left < block.right &&
         block.top < block.bottom && block.right <= picture.width() &&
         block.bottom <= picture.height();
}

}  // namespace

StateFile::StateFile(std::string path, std::string identity, Framebuffer& picture)
    : path_(std::move(path)),
      identity_("durer state " DURER_VERSION " " + identity + "\n"),
      picture_(picture),
      last_write_(std::chrono::steady_clock::now()) {}

StateFile::~StateFile() {
  if (file_) std::fclose(file_);
}

int64_t StateFile::load() {
  file_ = std::fopen(path_.c_str(), "r+b");
  if (!file_) return 0;
  std::string head(identity_.size(), '\0');
  if (std::fread(head.data(), 1, head.size(), file_) != head.size() || head != identity_) {
    std::fclose(file_);
    file_ = nullptr;
    return 0;
  }
  int64_t pixels = 0;
  long good_end = std::ftell(file_);
  PixelWindow block;
  while (std::fread(&block, sizeof block, 1, file_) == 1 && block_fits(block, picture_)) {
    // A block whose end is missing (the machine went down) is rendered again.
    std::vector<PixelColor> content(static_cast<size_t>(block.right - block.left) *
                                    static_cast<size_t>(block.bottom - block.top));
    if (std::fread(content.data(), sizeof(PixelColor), content.size(), file_) != content.size()) {
      break;
    }
    size_t i = 0;
    for (int y = block.top; y < block.bottom; ++y) {
      for (int x = block.left; x < block.right; ++x) picture_.at(x, y) = content[i++];
    }
    loaded_.insert({block.left, block.top});
    pixels += static_cast<int64_t>(content.size());
    good_end = std::ftell(file_);
  }
  // New blocks go where the good ones end.
  if (std::fseek(file_, good_end, SEEK_SET) != 0 || ftruncate(fileno(file_), good_end) != 0) {
    good_ = false;
  }
  return pixels;
}

void StateFile::block_done(const PixelWindow& block) {
  const std::lock_guard lock(mutex_);
  pending_.push_back(block);
  const auto now = std::chrono::steady_clock::now();
  if (now - last_write_ < kWriteInterval) return;
  last_write_ = now;
  write_pending();
}

bool StateFile::flush() {
  const std::lock_guard lock(mutex_);
  return write_pending();
}

bool StateFile::write_pending() {
  if (!good_) return false;
  if (!file_) {
    file_ = std::fopen(path_.c_str(), "wb");
    good_ = file_ && std::fwrite(identity_.data(), 1, identity_.size(), file_) == identity_.size();
  }
  for (const PixelWindow& block : pending_) {
    if (!good_) break;
    good_ = std::fwrite(&block, sizeof block, 1, file_) == 1;
    const size_t width = static_cast<size_t>(block.right - block.left);
    for (int y = block.top; good_ && y < block.bottom; ++y) {
      good_ = std::fwrite(&picture_.at(block.left, y), sizeof(PixelColor), width, file_) == width;
    }
  }
  pending_.clear();
  good_ = good_ && std::fflush(file_) == 0;
  return good_;
}

void StateFile::remove() {
  if (file_) std::fclose(file_);
  file_ = nullptr;
  std::remove(path_.c_str());
}

}  // namespace durer
