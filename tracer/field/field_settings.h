// What global_settings and #version say about noise and waves, as fields see it at evaluation time.
#pragma once

namespace durer {

// One record per parse, shared by every function and pattern made in it. The parser changes it while
// it reads (values computed then follow the statement in force, spec/functions.md 4.3); once `frozen`
// it is constant and may be read from any thread.
struct FieldSettings {
  int noise_generator = 2;  // 1..3; 1 while the language version is below 3.5
  // 10 during parsing whatever the text says (spec/textures.md 2.8): set it when parsing ends.
  int number_of_waves = 10;
  bool frozen = false;  // parsing is over: nothing below remembers its first caller any more
};

}  // namespace durer
