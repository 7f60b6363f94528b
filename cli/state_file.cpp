#include "cli/state_file.h"

#include <fcntl.h>
#include <libdeflate.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace durer {
namespace {

bool block_fits(const PixelWindow& block, const Picture& picture) {
  return block.left >= 0 && block.top >= 0 && !block.is_empty() &&
         block.right <= picture.width() && block.bottom <= picture.height();
}

bool read_all(int file, void* to, size_t size) {
  char* next = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t got = read(file, next, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    next += got;
    size -= static_cast<size_t>(got);
  }
  return true;
}

struct BlockHead {
  PixelWindow window;
  uint32_t checksum;
};

// Finds what a disk or an editor damaged.
uint32_t checksum_of(const Framebuffer& block) {
  const uint32_t of_pixels = libdeflate_crc32(0, block.pixels(), block.bytes());
  return libdeflate_crc32(of_pixels, &block.window(), sizeof(PixelWindow));
}

bool has_head(int file, const std::string& head) {
  std::string found(head.size(), '\0');
  return read_all(file, found.data(), found.size()) && found == head;
}

}  // namespace

StateFile::StateFile(std::string path, const std::string& identity)
    : path_(std::move(path)), identity_("durer state " DURER_VERSION " " + identity + "\n") {}

StateFile::~StateFile() { close(); }

void StateFile::close() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

bool StateFile::exists() const {
  const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool ours = has_head(file, identity_);
  ::close(file);
  return ours;
}

int64_t StateFile::load(Picture& picture) {
  file_ = open(path_.c_str(), O_RDWR | O_CLOEXEC);
  if (file_ < 0) return 0;
  if (!has_head(file_, identity_)) {
    close();
    return 0;
  }
  int64_t pixels = 0;
  off_t good_end = lseek(file_, 0, SEEK_CUR);
  BlockHead head;
  while (read_all(file_, &head, sizeof head) && block_fits(head.window, picture)) {
    // A block whose end is missing or that is damaged is rendered again, and all behind it.
    const PixelWindow& window = head.window;
    Framebuffer block(window);
    if (!read_all(file_, block.pixels(), block.bytes())) break;
    if (checksum_of(block) != head.checksum) break;
    picture.store(block);
    loaded_.insert({window.left, window.top});
    pixels += static_cast<int64_t>(window.width()) * window.height();
    good_end = lseek(file_, 0, SEEK_CUR);
  }
  // New blocks go where the good ones end.
  if (ftruncate(file_, good_end) != 0 || lseek(file_, good_end, SEEK_SET) < 0) good_ = false;
  return pixels;
}

bool StateFile::create() {
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  return file_ >= 0 && write(file_, identity_.data(), identity_.size()) ==
                           static_cast<ssize_t>(identity_.size());
}

bool StateFile::is_file_there() const { return access(path_.c_str(), F_OK) == 0; }

bool StateFile::add(const Framebuffer& block) {
  BlockHead head{block.window(), checksum_of(block)};
  const std::lock_guard lock(mutex_);
  if (!good_) return true;
  const iovec parts[2] = {{&head, sizeof head},
                          {const_cast<PixelColor*>(block.pixels()), block.bytes()}};
  const ssize_t whole = static_cast<ssize_t>(sizeof head + block.bytes());
  errno = ENOSPC;  // what a short write without an error means
  const ssize_t written = writev(file_, parts, 2);
  if (written == whole) return true;
  good_ = false;
  // Half a block would be taken for none, but the next run should not have to find out.
  const int reason = errno;
  const off_t before = lseek(file_, 0, SEEK_CUR) - std::max<ssize_t>(written, 0);
  if (ftruncate(file_, before) == 0) errno = reason;
  errno = reason;
  return false;
}

void StateFile::remove() {
  close();
  std::remove(path_.c_str());
}

}  // namespace durer
