#pragma once

#include <cstdint>
#include <set>
#include <string_view>

#include "scene/parameters.hpp"
#include "scene/scene.hpp"

namespace terrella {

// Paths of parameters that shall stay as they are.
using Locks = std::set<std::string_view>;

// Whether chance may change a parameter that is not locked.
bool is_for_chance(const Parameter& parameter);

// The planet of a scene drawn anew by chance. Each group comes from one preset, up to half of the way to another, and
// each seed from its whole range; terrain and water share their presets, so that there is land as well as sea, and the
// sun stands beside the camera as it does there. Camera, picture, time and quality stay, as do the radius and what is
// locked. The same for the same seed; a lock changes nothing but what it holds, and height and level which belong
// together.
Scene surprise(const Scene& scene, const Locks& locked, std::uint32_t seed);

}  // namespace terrella
