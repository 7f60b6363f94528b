// durer_openimageio.so: the one part that is linked with OpenImageIO. Loading that library takes longer
// than rendering a small picture, so it is a module of its own (design.md rule 9).
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>

#include "tracer/image/openimageio_interface.h"

namespace durer {
namespace {

// Nothing here starts threads: the number that the user gave holds for all phases.
void stay_in_this_thread() {
  static const bool done = [] {
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    return true;
  }();
  static_cast<void>(done);
}

// The caller's file. OpenImageIO's own files do not tell of a full disk when they are closed.
class OpenFile final : public OIIO::Filesystem::IOProxy {
 public:
  explicit OpenFile(std::FILE* file) : IOProxy("picture", Write), file_(file) {}

  const char* proxytype() const override { return "durer"; }
  bool opened() const override { return true; }
  bool seek(int64_t offset) override {
    m_pos = offset;
    return keep_reason(fseeko(file_, offset, SEEK_SET) == 0);
  }
  int64_t tell() override { return ftello(file_); }
  size_t read(void* to, size_t size) override {
    std::fflush(file_);
    return std::fread(to, 1, size, file_);
  }
  size_t write(const void* from, size_t size) override {
    // A Targa's empty thumbnail comes as a null pointer.
    if (size == 0) return 0;
    const size_t written = std::fwrite(from, 1, size, file_);
    keep_reason(written == size);
    return written;
  }
  size_t pread(void* to, size_t size, int64_t offset) override {
    const int64_t before = tell();
    seek(offset);
    const size_t got = read(to, size);
    seek(before);
    return got;
  }
  size_t pwrite(const void* from, size_t size, int64_t offset) override {
    const int64_t before = tell();
    seek(offset);
    const size_t written = write(from, size);
    seek(before);
    return written;
  }
  size_t size() const override {
    const off_t before = ftello(file_);
    fseeko(file_, 0, SEEK_END);
    const off_t end = ftello(file_);
    fseeko(file_, before, SEEK_SET);
    return static_cast<size_t>(end);
  }
  void flush() const override { keep_reason(std::fflush(file_) == 0); }

  // Of the first failure; 0: none.
  int reason() const { return reason_; }

 private:
  bool keep_reason(bool good) const {
    if (!good && reason_ == 0) reason_ = errno ? errno : EIO;
    return good;
  }

  std::FILE* file_;
  mutable int reason_ = 0;
};

class OpenImageIoWriter final : public ImageRowWriter {
 public:
  OpenImageIoWriter(std::FILE* file, OIIO::TypeDesc type) : file_(file), type_(type) {}

  bool open(const ImageFileLayout& layout, const OIIO::ImageSpec& spec) {
    output_ = OIIO::ImageOutput::create(layout.format);
    return output_ && output_->set_ioproxy(&file_) && output_->open("picture", spec);
  }
  const char* write_row(int y, const void* row) override {
    const bool good = output_->write_scanline(y, 0, type_, row);
    return good && file_.reason() == 0 ? nullptr : failure();
  }
  const char* finish() override {
    const bool good = output_->close();
    file_.flush();
    return good && file_.reason() == 0 ? nullptr : failure();
  }
  const char* failure() {
    if (file_.reason() != 0) {
      message_ = std::strerror(file_.reason());
    } else {
      message_ = output_ ? output_->geterror() : OIIO::geterror();
    }
    if (message_.empty()) message_ = "unknown error";
    return message_.c_str();
  }

 private:
  OpenFile file_;  // outlives output_
  std::unique_ptr<OIIO::ImageOutput> output_;
  OIIO::TypeDesc type_;
  std::string message_;
};

OIIO::TypeDesc row_type(int bits) {
  return bits == 8    ? OIIO::TypeDesc::UINT8
         : bits == 16 ? OIIO::TypeDesc::UINT16
                      : OIIO::TypeDesc::FLOAT;
}

}  // namespace
}  // namespace durer

extern "C" durer::ImageRowWriter* durer_open_image_writer(std::FILE* file,
                                                          const durer::ImageFileLayout* layout,
                                                          const char** message) {
  durer::stay_in_this_thread();
  const OIIO::TypeDesc type = durer::row_type(layout->bits);
  OIIO::ImageSpec spec(layout->width, layout->height, layout->channels,
                       layout->half ? OIIO::TypeDesc(OIIO::TypeDesc::HALF) : type);
  // The values are what they are: no division by alpha, no curve behind our back.
  spec["oiio:UnassociatedAlpha"] = 1;
  if (layout->compression) spec["compression"] = layout->compression;
  if (layout->gamma > 0) spec["oiio:Gamma"] = layout->gamma;
  spec["jpeg:subsampling"] = "4:4:4";
  // A date would make two equal pictures differ.
  spec["DateTime"] = "1525:01:01 00:00:00";
  spec["Software"] = "durer";
  auto writer = std::make_unique<durer::OpenImageIoWriter>(file, type);
  if (writer->open(*layout, spec)) return writer.release();
  thread_local std::string text;
  text = writer->failure();
  *message = text.c_str();
  return nullptr;
}

// Returns nothing on success, else a message that lives as long as the thread.
extern "C" const char* durer_read_image(const char* path, durer::RasterFile* file) {
  thread_local std::string message;
  durer::stay_in_this_thread();
  OIIO::ImageSpec as_stored;
  as_stored["oiio:UnassociatedAlpha"] = 1;  // no multiplication behind our back
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &as_stored);
  if (!input) {
    message = OIIO::geterror();
    return message.c_str();
  }
  const OIIO::ImageSpec& spec = input->spec();
  file->width = spec.width;
  file->height = spec.height;
  const int stored = spec.nchannels;
  file->channels = std::min(stored, 4);
  const size_t count = static_cast<size_t>(spec.width) * spec.height * file->channels;
  OIIO::TypeDesc type;
  void* target;
  if (spec.format.basetype == OIIO::TypeDesc::UINT8) {
    file->bits = 8;
    file->bytes.resize(count);
    type = OIIO::TypeDesc::UINT8;
    target = file->bytes.data();
  } else if (spec.format.basetype == OIIO::TypeDesc::UINT16) {
    file->bits = 16;
    file->words.resize(count);
    type = OIIO::TypeDesc::UINT16;
    target = file->words.data();
  } else {
    file->bits = 32;
    file->floats.resize(count);
    type = OIIO::TypeDesc::FLOAT;
    target = file->floats.data();
  }
  if (!input->read_image(0, 0, 0, file->channels, type, target)) {
    message = input->geterror();
    return message.c_str();
  }
  file->straight_alpha = spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
  return nullptr;
}
