// The finished blocks of a render, kept beside the picture so that it can be continued (+C).
//
// Layout: a text line with all that the picture depends on here (size, window, antialiasing, scene),
// then records: left, top, right, bottom as int32, followed by the pixels row by row. Written now
// and then while rendering, so that a machine that goes down loses little, and read only by the same
// version of the program on the same kind of machine.
#pragma once

#include <chrono>
#include <cstdio>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/options.h"
#include "tracer/image/framebuffer.h"

namespace durer {

class StateFile {
 public:
  // `identity`: one line; a file with another one is not continued.
  StateFile(std::string path, std::string identity, Framebuffer& picture);
  ~StateFile();
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;

  // Reads finished blocks into the picture. Returns their number of pixels; 0: nothing to continue.
  int64_t load();
  bool has(const PixelWindow& block) const { return loaded_.count({block.left, block.top}) > 0; }

  // From any thread. Writes to the disk every few seconds.
  void block_done(const PixelWindow& block);
  // Writes all that is missing. False: it could not be written.
  bool flush();
  // After the picture is written.
  void remove();

 private:
  bool write_pending();

  const std::string path_, identity_;
  Framebuffer& picture_;
  std::FILE* file_ = nullptr;
  bool good_ = true;
  std::set<std::pair<int, int>> loaded_;
  std::vector<PixelWindow> pending_;
  std::chrono::steady_clock::time_point last_write_;
  std::mutex mutex_;
};

}  // namespace durer
