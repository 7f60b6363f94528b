// Names of the files that a render writes (spec/language.md 32).
#pragma once

#include <string>

namespace durer {

// Without the dot; `type` is a letter of Output_File_Type.
const char* extension_of(char type);
bool is_standard_stream(const std::string& output_name);  // "-", "stdout", "stderr"
// The picture's path. `frame` is the frame number as text, empty without animation.
std::string output_path(const std::string& input_name, const std::string& output_name, char type,
                        const std::string& frame);
// With the final slash; empty: the current folder.
std::string folder_of(const std::string& path);
std::string file_part_of(const std::string& path);
// Where an interrupted render is kept, beside the picture.
std::string state_path(const std::string& picture_path);

}  // namespace durer
