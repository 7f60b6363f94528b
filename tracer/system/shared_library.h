// Libraries of the system that are loaded when they are first needed.
#pragma once

namespace durer {

class SharedLibrary {
 public:
  // `name`: as the dynamic linker knows it ("libjpeg.so.62"). Throws std::runtime_error if there is
  // none. Stays loaded until the program ends.
  explicit SharedLibrary(const char* name);

  // The function of this name; throws std::runtime_error if it is missing.
  template <typename Function>
  Function* find(const char* function) const {
    return reinterpret_cast<Function*>(address(function));
  }

 private:
  void* address(const char* function) const;

  const char* name_;
  void* handle_;
};

// A table of what is used of one library, loaded when it is first asked for.
template <typename Table>
const Table& loaded() {
  static const Table table;
  return table;
}

// Declares a member of the name and type that a function has in the library's header, for tables of
// what is used of a library: struct Jpeg { SharedLibrary library{...}; DURER_IMPORT(jpeg_read_header); };
#define DURER_IMPORT(function) \
  decltype(&::function) function = library.find<decltype(::function)>(#function)

}  // namespace durer
