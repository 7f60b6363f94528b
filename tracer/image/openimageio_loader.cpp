#include "tracer/image/openimageio_loader.h"

#include <dlfcn.h>
#include <unistd.h>

#include <climits>
#include <cstdlib>
#include <stdexcept>

namespace durer {
namespace {

// Libraries that OpenImageIO brings along start threads as soon as they are loaded, unless told not to.
void forbid_threads() {
  for (const char* name : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "OPENIMAGEIO_THREADS"}) {
    setenv(name, "1", 1);
  }
}

// The module lies beside the executable in a build tree and below ../lib/durer when installed.
void* load_module() {
  forbid_threads();
  char executable[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", executable, sizeof executable - 1);
  std::string folder(executable, length > 0 ? static_cast<size_t>(length) : 0);
  folder.resize(folder.rfind('/') == std::string::npos ? 0 : folder.rfind('/'));
  for (const char* place : {"/durer_openimageio.so", "/../lib/durer/durer_openimageio.so",
                            "/../cli/durer_openimageio.so"}) {
    if (void* module = dlopen((folder + place).c_str(), RTLD_NOW | RTLD_LOCAL)) return module;
  }
  const char* reason = dlerror();
  throw std::runtime_error(std::string("the module durer_openimageio.so cannot be loaded: ") +
                           (reason ? reason : "unknown error"));
}

void* symbol(const char* name) {
  static void* const module = load_module();
  if (void* address = dlsym(module, name)) return address;
  throw std::runtime_error(std::string("the module durer_openimageio.so has no ") + name);
}

}  // namespace

ReadImageFunction read_image_function() {
  return reinterpret_cast<ReadImageFunction>(symbol("durer_read_image"));
}

OpenImageWriterFunction open_image_writer() {
  return reinterpret_cast<OpenImageWriterFunction>(symbol("durer_open_image_writer"));
}

RasterFile read_with_openimageio(const std::string& path) {
  RasterFile file;
  if (const char* message = read_image_function()(path.c_str(), &file))
    throw std::runtime_error("the image '" + path + "' cannot be read: " + message);
  return file;
}

}  // namespace durer
