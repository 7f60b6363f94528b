// The functions of the module with OpenImageIO; it is loaded when one is first asked for.
#pragma once

#include "tracer/image/openimageio_interface.h"

namespace durer {

// Both throw std::runtime_error if the module cannot be loaded.
ReadImageFunction read_image_function();
OpenImageWriterFunction open_image_writer();

}  // namespace durer
