// durer_openimageio.so: the one part that is linked with OpenImageIO. Loading that library takes longer
// than rendering a small picture, so it is a module of its own (design.md rule 9).
#include <OpenImageIO/imageio.h>

#include <memory>

#include "tracer/image/raster_file.h"

// Returns nothing on success, else a message that lives as long as the thread.
extern "C" const char* durer_read_image(const char* path, durer::RasterFile* file) {
  thread_local std::string message;
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
  return nullptr;
}
