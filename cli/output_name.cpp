#include "cli/output_name.h"

namespace durer {

const char* extension_of(char type) {
  switch (type) {
    case 'T':
    case 'C':
      return "tga";
    case 'J':
      return "jpg";
    case 'P':
      return "ppm";
    case 'B':
      return "bmp";
    case 'E':
      return "exr";
    case 'H':
      return "hdr";
    case 'F':
      return "tif";
    default:
      return "png";
  }
}

bool is_standard_stream(const std::string& name) {
  return name == "-" || name == "stdout" || name == "stderr";
}

std::string folder_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

std::string file_part_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string state_path(const std::string& picture_path) {
  const size_t dot = picture_path.rfind('.');
  return picture_path.substr(0, dot) + ".pov-state";
}

std::string output_path(const std::string& input_name, const std::string& output_name, char type,
                        const std::string& frame) {
  const std::string extension = std::string(".") + extension_of(type);
  std::string input_base = file_part_of(input_name);
  input_base.resize(std::min(input_base.rfind('.'), input_base.size()));

  std::string stem;
  std::string file = file_part_of(output_name);
  if (output_name.empty()) {
    stem = folder_of(input_name) + input_base;
  } else if (file.empty() || file == extension) {
    // Only a folder is given, or only the extension.
    const std::string folder = folder_of(output_name);
    stem = (folder.empty() ? folder_of(input_name) : folder) + input_base;
  } else {
    if (file.back() == '.') {
      file.pop_back();
    } else if (file.size() > extension.size() &&
               file.compare(file.size() - extension.size(), extension.size(), extension) == 0) {
      file.resize(file.size() - extension.size());
    }
    stem = folder_of(output_name) + file;
  }
  return stem + frame + extension;
}

}  // namespace durer
