#include <dlfcn.h>

#include <climits>
#include <stdexcept>
#include <unistd.h>

#include "tracer/image/raster_file.h"

namespace durer {
namespace {

using ReadImage = const char* (*)(const char*, RasterFile*);

// The module lies beside the executable in a build tree and below ../lib/durer when installed.
ReadImage load_module() {
  char executable[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", executable, sizeof executable - 1);
  std::string folder(executable, length > 0 ? static_cast<size_t>(length) : 0);
  folder.resize(folder.rfind('/') == std::string::npos ? 0 : folder.rfind('/'));
  for (const char* place : {"/durer_openimageio.so", "/../lib/durer/durer_openimageio.so",
                            "/../cli/durer_openimageio.so"}) {
    if (void* module = dlopen((folder + place).c_str(), RTLD_NOW | RTLD_LOCAL)) {
      if (void* symbol = dlsym(module, "durer_read_image"))
        return reinterpret_cast<ReadImage>(symbol);
    }
  }
  const char* reason = dlerror();
  throw std::runtime_error(std::string("the module durer_openimageio.so cannot be loaded: ") +
                           (reason ? reason : "unknown error"));
}

}  // namespace

RasterFile read_with_openimageio(const std::string& path) {
  static const ReadImage read = load_module();
  RasterFile file;
  if (const char* message = read(path.c_str(), &file))
    throw std::runtime_error("the image '" + path + "' cannot be read: " + message);
  return file;
}

}  // namespace durer
