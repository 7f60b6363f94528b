// Dense numbers for textures, each moved to its final place and compiled once.
#pragma once

#include <array>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tracer/system/pages_ahead.h"
#include "tracer/texture/surface_texture.h"
#include "tracer/world/resolved_object.h"

namespace durer {

class TextureTable {
 public:
  // The compiled ones go to `textures`.
  TextureTable(std::vector<CompiledTexture>& textures, const TextureSettings& settings)
      : textures_(textures), settings_(settings) {}

  // The number of the texture at its place; equal textures at equal places share one.
  uint32_t index_of(const MovedTexture& texture);
  // Whether looking it up needs the surface's uv.
  bool uses_uv(uint32_t index) const { return uses_uv_[index]; }

 private:
  uint32_t add(const TextureNode& texture);

  using Placement = std::array<double, 12>;
  std::vector<CompiledTexture>& textures_;
  TextureSettings settings_;
  std::unordered_map<const TextureNode*, uint32_t> unmoved_;
  std::map<std::pair<const TextureNode*, Placement>, uint32_t> moved_;
  std::vector<TexturePtr> kept_;  // originals, so that their addresses stay theirs
  std::vector<bool> uses_uv_;
  PagesAhead pages_;  // of textures_
};

}  // namespace durer
