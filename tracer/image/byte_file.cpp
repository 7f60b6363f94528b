#include "tracer/image/byte_file.h"

#include <fstream>
#include <iterator>

namespace durer {

ByteFile::ByteFile(const std::string& path) : path_(path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("the image '" + path + "' cannot be opened");
  bytes_.assign(std::istreambuf_iterator<char>(file), {});
}

}  // namespace durer
