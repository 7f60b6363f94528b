// What scenes of a language before 3.0 write into texture{} without pigment{}, normal{} and
// finish{}: `texture { 0.05 wood turbulence 0.3 color_map {...} bumps 0.4 scale 0.1 phong 1 }`.
//
// Each item changes the pigment, the normal or the finish that the texture has so far, in the order
// of the text; several may give the same thing, the last one holds. Which items there are and what
// they change was measured on povray 3.7.
#pragma once

#include "tracer/scene/texture.h"

namespace durer {

class Parser;

class LooseTextureItems {
 public:
  // `start`: the texture before its first item.
  LooseTextureItems(Parser& parser, const TextureNode& start)
      : parser_(parser), owns_normal_(start.normal != nullptr) {}

  // If such an item comes next: reads it and changes the texture.
  bool accept(TexturePtr& texture);
  // After the last item: an error if the texture cannot be used.
  void finish(const TextureNode& texture) const;

 private:
  bool accept_pigment_item(TexturePtr& texture);
  bool accept_normal_item(TexturePtr& texture);
  bool accept_finish_item(TexturePtr& texture);
  bool accept_pattern(PigmentNode& pigment);
  // The normal that loose items change. If only a normal{} has given one, they do not see it: povray 3.7
  // starts from the default's then.
  NormalNode& edit_normal(TexturePtr& texture);
  // Until language 1.5 povray names the statement that the word belongs into.
  void warn(const char* statement);

  Parser& parser_;
  bool owns_normal_;
  bool changed_waves_ = false;  // frequency or phase
};

}  // namespace durer
