// Dense numbers for textures, each moved to its final place once (world.h, World::take_textures()).
#pragma once

#include <array>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tracer/world/resolved_object.h"

namespace durer {

class TextureTable {
 public:
  // Makes room for as many textures.
  void expect(size_t textures) { textures_.reserve(textures); }
  // The number of the texture at its place; equal textures at equal places share one.
  uint32_t index_of(const MovedTexture& texture);
  // Whether looking it up needs the surface's uv.
  bool uses_uv(uint32_t index) const { return uses_uv_[index]; }
  // Ends the table's work: what it looked textures up by goes.
  std::vector<TexturePtr> take();

 private:
  uint32_t add(const TexturePtr& texture);

  using Placement = std::array<double, 12>;
  std::unordered_map<const TextureNode*, uint32_t> unmoved_;
  std::map<std::pair<const TextureNode*, Placement>, uint32_t> moved_;
  std::vector<TexturePtr> textures_;
  std::vector<TexturePtr> kept_;  // originals, so that their addresses stay theirs
  std::vector<bool> uses_uv_;
};

}  // namespace durer
