#include "tracer/system/shared_library.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace durer {

SharedLibrary::SharedLibrary(const char* name)
    : name_(name), handle_(dlopen(name, RTLD_LAZY | RTLD_LOCAL)) {
  if (handle_) return;
  const char* reason = dlerror();
  throw std::runtime_error(std::string("the library ") + name + " cannot be loaded: " +
                           (reason ? reason : "unknown error"));
}

void* SharedLibrary::address(const char* function) const {
  if (void* address = dlsym(handle_, function)) return address;
  throw std::runtime_error(std::string("the library ") + name_ + " has no function " + function);
}

}  // namespace durer
