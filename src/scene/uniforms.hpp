#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

// The scene as the shaders read it: one std140 uniform block. Colours come first, then reals, then whole numbers, bools
// and choices, each kind in the order of params.inc. The groups camera, quality and time are for the CPU only, and so
// are files.
namespace terrella {

struct BlockMember {
  std::string name;    // "terrain_height"
  std::size_t offset;  // bytes
};

// The members in the block's order.
std::span<const BlockMember> block_members();

// The block's bytes, a multiple of 16. Colours become linear light with alpha 1; lengths (m) and speeds (m/s) are
// divided by the planet's radius, in double precision; planet.radius itself is 1.
std::vector<std::byte> pack_scene(const Scene& scene);

}  // namespace terrella
