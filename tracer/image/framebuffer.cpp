#include "tracer/image/framebuffer.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace durer {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

off_t offset_of(int x, int y, int width) {
  return (static_cast<off_t>(y) * width + x) * static_cast<off_t>(sizeof(PixelColor));
}

}  // namespace

PixelWindow intersection(const PixelWindow& a, const PixelWindow& b) {
  const PixelWindow common{std::max(a.left, b.left), std::max(a.top, b.top),
                           std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
  return common.is_empty() ? PixelWindow{} : common;
}

void Framebuffer::store(const Framebuffer& block) {
  const PixelWindow& area = block.window();
  for (int y = area.top; y < area.bottom; ++y) {
    std::copy_n(&block.at(area.left, y), area.width(), &at(area.left, y));
  }
}

void Framebuffer::read(int y, int left, int right, PixelColor* out) const {
  std::copy_n(&at(left, y), right - left, out);
}

ScratchPicture::ScratchPicture(int width, int height, const std::string& folder)
    : width_(width), height_(height) {
  std::string name = folder + "durer-picture-XXXXXX";
  descriptor_ = mkstemp(name.data());
  if (descriptor_ < 0) fail("cannot make a file for the picture in '" + folder + "'");
  unlink(name.c_str());
  // Holes read as zeros: opaque black.
  if (ftruncate(descriptor_, offset_of(0, height, width)) != 0) {
    close(descriptor_);
    fail("cannot keep a picture of this size on the disk");
  }
}

ScratchPicture::~ScratchPicture() { close(descriptor_); }

void ScratchPicture::store(const Framebuffer& block) {
  const PixelWindow& area = block.window();
  for (int y = area.top; y < area.bottom; ++y) {
    const char* from = reinterpret_cast<const char*>(&block.at(area.left, y));
    size_t left = static_cast<size_t>(area.width()) * sizeof(PixelColor);
    off_t to = offset_of(area.left, y, width_);
    while (left > 0) {
      const ssize_t written = pwrite(descriptor_, from, left, to);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail("cannot keep the picture on the disk");
      from += written;
      to += written;
      left -= static_cast<size_t>(written);
    }
  }
}

void ScratchPicture::read(int y, int left, int right, PixelColor* out) const {
  char* to = reinterpret_cast<char*>(out);
  size_t missing = static_cast<size_t>(right - left) * sizeof(PixelColor);
  off_t from = offset_of(left, y, width_);
  while (missing > 0) {
    const ssize_t got = pread(descriptor_, to, missing, from);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail("cannot read the picture back from the disk");
    to += got;
    from += got;
    missing -= static_cast<size_t>(got);
  }
}

std::unique_ptr<Picture> make_picture(int width, int height, size_t most_bytes,
                                      const std::string& folder) {
  const size_t bytes =
      static_cast<size_t>(width) * static_cast<size_t>(height) * sizeof(PixelColor);
  if (bytes <= most_bytes) return std::make_unique<Framebuffer>(width, height);
  return std::make_unique<ScratchPicture>(width, height, folder);
}

}  // namespace durer
