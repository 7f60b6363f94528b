#include "tracer/image/picture_writer.h"

#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace durer {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& reason) {
  throw std::runtime_error("cannot write '" + name + "': " + reason);
}
[[noreturn]] void fail(const std::string& name) { fail(name, std::strerror(errno)); }

// A file that disappears unless it is kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path)
      : path_(path), stream_(std::fopen(path.c_str(), "w+b")) {}
  ~TemporaryFile() {
    if (stream_) std::fclose(stream_);
    if (!kept_) std::remove(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::FILE* stream() const { return stream_; }
  // False: errno says why.
  bool keep_as(const std::string& path) {
    const bool closed = std::fclose(stream_) == 0;
    stream_ = nullptr;
    kept_ = closed && std::rename(path_.c_str(), path.c_str()) == 0;
    return kept_;
  }

 private:
  const std::string path_;
  std::FILE* stream_;
  bool kept_ = false;
};

void encode(std::FILE* file, const std::string& name, const Picture& picture,
            const PictureOutput& output) {
  try {
    if (output.type == PictureFileType::png) {
      encode_png(file, picture, output);
    } else if (output.type == PictureFileType::ppm) {
      encode_pnm(file, picture, output);
    } else if (output.type == PictureFileType::bmp) {
      encode_bmp(file, picture, output);
    } else if (output.type == PictureFileType::tga || output.type == PictureFileType::tga_rle) {
      encode_tga(file, picture, output);
    } else {
      encode_with_openimageio(file, picture, output);
    }
  } catch (const std::exception& error) {
    fail(name, error.what());
  }
}

bool needs_seeking(PictureFileType type) {
  switch (type) {
    case PictureFileType::png:
    case PictureFileType::ppm:
    case PictureFileType::bmp:
    case PictureFileType::tga:
    case PictureFileType::tga_rle:
      return false;
    default:
      return true;
  }
}

void write_to_standard_output(const Picture& picture, const PictureOutput& output) {
  const std::string name = "standard output";
  if (!needs_seeking(output.type)) {
    encode(stdout, name, picture, output);
  } else {
    // A pipe cannot seek.
    const std::unique_ptr<std::FILE, decltype(&std::fclose)> file(std::tmpfile(), &std::fclose);
    if (!file) fail("a temporary file");
    encode(file.get(), "a temporary file", picture, output);
    std::rewind(file.get());
    char buffer[65536];
    while (const size_t got = std::fread(buffer, 1, sizeof buffer, file.get())) {
      if (std::fwrite(buffer, 1, got, stdout) != got) fail(name);
    }
  }
  if (std::fflush(stdout) != 0) fail(name);
}

}  // namespace

void write_picture_file(const std::string& path, const Picture& picture,
                        const PictureOutput& output) {
  if (path == "-") {
    write_to_standard_output(picture, output);
    return;
  }
  // Always the same name: what a killed run left behind is written over by the next.
  TemporaryFile temporary(path + ".part");
  if (!temporary.stream()) fail(path);
  encode(temporary.stream(), path, picture, output);
  if (!temporary.keep_as(path)) fail(path);
}

}  // namespace durer
