// The finished blocks of a render, kept beside the picture so that it can be continued (+C).
//
// Layout: a text line with all that the picture depends on here (size, window, antialiasing, scene),
// then records: left, top, right, bottom as int32 and a checksum of 64 bits, followed by the pixels row
// by row. Each block is handed to the system as soon as it is finished: whoever kills the program loses
// the blocks in hand. Read only by the same version of the program on the same kind of machine.
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "tracer/image/framebuffer.h"

namespace durer {

class StateFile {
 public:
  // `identity`: one line; a file with another one is not continued.
  StateFile(std::string path, const std::string& identity);
  ~StateFile();
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;

  // Whether there is a file of this identity: the picture is not finished.
  bool exists() const;
  // Whether there is a file of that name, perhaps of another picture.
  bool is_file_there() const;
  // Opens it and reads its blocks into the picture. Returns their number of pixels; 0: there is
  // nothing to continue. Throws std::runtime_error if the picture cannot hold them.
  int64_t load(Picture& picture);
  // Makes an empty file. False: errno says why.
  bool create();
  bool has(const PixelWindow& block) const { return loaded_.count({block.left, block.top}) > 0; }

  // From any thread. False, once: the file cannot be written any more (errno); what it has stays.
  bool add(const Framebuffer& block);
  // After the picture is written.
  void remove();

 private:
  void close();

  const std::string path_, identity_;
  int file_ = -1;
  bool good_ = true;
  std::set<std::pair<int, int>> loaded_;
  std::mutex mutex_;
};

}  // namespace durer
