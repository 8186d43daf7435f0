// A map of heights as shaders read it (lib/height_map.glsl): one texel at a time, as 32 bit floats.
#pragma once

#include <cstdint>
#include <optional>

#include "base/height_map.hpp"
#include "gl/handle.hpp"
#include "gl/ledger.hpp"

namespace terrella::gl {

class HeightTexture {
 public:
  // With all levels of the map but those that the driver's textures have no room for.
  explicit HeightTexture(const HeightMap& map);

  // Makes the texture of a map, unless it is there; of none, null, there is none.
  static void keep(std::optional<HeightTexture>& texture, const HeightMap* map);

  void bind(int unit) const;

 private:
  TextureHandle texture_;
  std::uint64_t serial_;  // of the map
  Holding memory_;
  CountedTexture counted_;
};

}  // namespace terrella::gl
